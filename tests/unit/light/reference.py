#!/usr/bin/env python3
"""Writes reference.csv beside it: the measures of the shapes to 50 digits, from their textbook definitions.

Spots are integrated numerically; the other forms are the textbook's, with digits to spare for what they cancel; a
tube's illuminance is Lambert's contour integral along the outline of a capsule. Every argument is exact in float.
Needs mpmath: python3 tests/unit/light/reference.py
"""
import os
import random
import struct

from mpmath import mp, mpf, acos, asin, atan, cos, log, pi, quad, sin, sqrt, nstr

mp.dps = 90  # forms that cancel lose up to 35 of them here


def single(x):
    """The float nearest to x."""
    return struct.unpack("f", struct.pack("f", x))[0]


def spot(fall):
    """2 pi times the integral of f(t) sin t, f = 1 up to a and fall(t, a, b) from there to b."""

    def solid_angle(a, b):
        if not a < b:
            return 2 * pi * (1 - cos(b))
        return 2 * pi * (1 - cos(a) + quad(lambda t: fall(t, a, b) * sin(t), [a, b]))

    return solid_angle


def by_cosine(t, a, b):
    return (cos(t) - cos(b)) / (cos(a) - cos(b))


def by_angle(t, a, b):
    return (b - t) / (b - a)


def smooth(x):
    return x * x * (3 - 2 * x)


falloffs = {
    "hard": lambda a, b: 2 * pi * (1 - cos(b)),
    "frostbite": spot(lambda t, a, b: by_cosine(t, a, b) ** 2),
    "linear-cos": spot(by_cosine),
    "smoothstep-cos": spot(lambda t, a, b: smooth(by_cosine(t, a, b))),
    "linear-angle": spot(by_angle),
    "smoothstep-angle": spot(lambda t, a, b: smooth(by_angle(t, a, b))),
}


def frustum(h, v):
    return 4 * asin(sin(h / 2) * sin(v / 2))


def disk_area(r):
    return pi * r * r


def tube_area(r, l):
    return 2 * r * l + pi * r * r


def tube_solid_angle(r, l):
    return pi * (2 * pi * r * l + 4 * pi * r * r) / (2 * r * l + pi * r * r)


def sun(delta):
    return pi * sin(delta / 2) ** 2


def facing_sphere(r, d):
    return pi * r * r / d**2


def facing_disk(r, d):
    return pi * r * r / (d**2 + r**2)


def facing_rect(w, h, d):
    a, b = w / (2 * d), h / (2 * d)
    ra, rb = sqrt(1 + a * a), sqrt(1 + b * b)
    return 2 * (a / ra * atan(b / ra) + b / rb * atan(a / rb))


def facing_tube(r, l, d):
    """Lambert's contour integral along the outline: 2 great arcs (the tangent planes of the cylinder) and 2 caps."""
    z = l / 2
    s = r / d
    # Tangent planes contain the direction of the axis x and touch the cylinder at the angle asin(s) from the centre:
    # each arc runs between the ends' azimuths; its edge normal has the cosine s with the receiver's normal.
    kappa = sqrt(1 - s * s)
    arcs = 2 * s * atan(z / (d * kappa)) if kappa > 0 else pi * s
    # A cap is part of a sphere's outline, a circle of angular radius asin(r/D) about the direction of the end; seen
    # from the receiver, its share is the integral of n . (c x dc)/2 over the half of the circle that is outside.
    D = sqrt(d * d + z * z)
    sin_a = r / D
    cos_a = sqrt(1 - sin_a**2)
    # Axis of the end: (z, 0, d)/D. The circle is cos_a e + sin_a (u cos t + v sin t), u = (d, 0, -z)/D outward, v = y.
    # n . (c x c') with n = (0, 0, 1): the integral of c_x c'_y - c_y c'_x over |t| <= h.
    h = acos((r * z) / (d * sqrt(D * D - r * r))) if kappa > 0 else mpf(0)
    # c_x = cos_a z/D + sin_a d/D cos t, c_y = sin_a sin t
    # c_x c_y' - c_y c_x' = cos_a sin_a z/D cos t + sin_a^2 d/D
    cap = cos_a * sin_a * z / D * 2 * sin(h) + sin_a**2 * d / D * 2 * h
    # Two caps, half of each contour integral.
    return arcs + cap


def cylinder_area(r, l):
    return 2 * r * l


def facing_cylinder(r, l, d):
    """The integral over the side of cos cos' / distance^2, along the axis in closed form, across it in thirds.

    At the angle t about the axis, from the middle, the distance of a line of the side is rho, its normal has the
    cosine (d cos t - r)/distance with the way to the receiver, and the receiver's is (d - r cos t)/distance.
    """
    z = l / 2
    most = acos(r / d)
    gap = d - r

    def line(t):
        rho2 = gap**2 + 4 * d * r * sin(t / 2) ** 2
        rho = sqrt(rho2)
        along = z / (rho2 * (rho2 + z * z)) + atan(z / rho) / rho**3
        return 2 * r * (gap - 2 * d * sin(t / 2) ** 2) * (gap + 2 * r * sin(t / 2) ** 2) * along

    if most == 0:
        return pi
    # The peak is as wide as the distance from the surface.
    places = [mpf(0)]
    width = gap / r
    while width < most:
        places.append(width)
        width *= 2
    return quad(line, places + [most])


def luminance_of_ev(ev):
    return mpf(2) ** (ev - 3)


def ev_of_luminance(nits):
    return log(nits, 2) + 3


def illuminance_of_ev(ev):
    return mpf(5) / 2 * mpf(2) ** ev


def ev_of_illuminance(lux):
    return log(lux / (mpf(5) / 2), 2)


rng = random.Random(20)


def spread(low, high):
    return single(low * (high / low) ** rng.random())


def angles():
    """Pairs inner <= outer: wide, narrow, all but equal, a penumbra alone."""
    half = single(1.5707963)
    for outer in [half, 1e-8, 1e-4, 0.01, 0.3, 0.785, 1.2] + [spread(1e-8, 1.57) for _ in range(12)]:
        outer = single(outer)
        yield 0.0, outer
        yield single(outer * rng.random()), outer
        yield single(outer * (1 - 2.0 ** -rng.randint(2, 22))), outer
        yield single(outer * 2.0 ** -rng.randint(2, 30)), outer
        yield outer, outer


def cases():
    for name, form in falloffs.items():
        for a, b in angles():
            yield "spot " + name, form, (a, b)
    near_pi = single(3.1415925)
    for h, v in [(near_pi, near_pi), (near_pi, 1.0), (1e-7, near_pi), (1e-7, 1e-7), (3.0, 3.1)] + \
            [(spread(1e-8, 3.14), spread(1e-3, 3.14)) for _ in range(40)]:
        yield "frustum", frustum, (single(h), single(v))
    for _ in range(30):
        r, l = spread(1e-6, 1e4), spread(1e-6, 1e4)
        yield "disk area", disk_area, (r,)
        yield "tube area", tube_area, (r, l)
        yield "tube solid angle", tube_solid_angle, (r, l)
        yield "cylinder area", cylinder_area, (r, l)
        yield "sun", sun, (spread(1e-6, 3.14159),)
    for k in range(60):
        r = spread(1e-6, 1e6)
        beyond = single(r * (1 + 2.0 ** -rng.randint(1, 22))) if k % 3 == 0 else spread(float(r), r * 1e12)
        anywhere = spread(r * 1e-12, r * 1e12)
        w, h, l = spread(1e-6, 1e6), spread(1e-6, 1e6), spread(r * 1e-9, r * 1e9)
        if k % 3 == 0:  # an end as near as the skin: both arctangents in their bends
            l = single(2 * max(beyond - r, 1e-9 * r) ** 0.5 * beyond**0.5)
        yield "facing sphere", facing_sphere, (r, beyond)
        yield "facing disk", facing_disk, (r, anywhere)
        yield "facing rect", facing_rect, (w, h, spread(1e-9, 1e9))
        yield "facing tube", facing_tube, (r, l, beyond)
        if k % 5 == 0:
            yield "facing tube", facing_tube, (r, l, r)
            yield "facing sphere", facing_sphere, (r, r)
        if k < 30:
            yield "facing cylinder", facing_cylinder, (r, l, beyond)
        if k % 20 == 0:
            yield "facing cylinder", facing_cylinder, (r, l, r)
    for _ in range(30):
        yield "luminance of ev", luminance_of_ev, (single(rng.uniform(-30, 40)),)
        yield "illuminance of ev", illuminance_of_ev, (single(rng.uniform(-30, 40)),)
        yield "ev of luminance", ev_of_luminance, (spread(1e-9, 1e12),)
        yield "ev of luminance", ev_of_luminance, (single(0.125 * (1 + rng.choice([-1, 1]) * 2.0 ** -rng.randint(1, 22))),)
        yield "ev of illuminance", ev_of_illuminance, (spread(1e-9, 1e12),)
        yield "ev of illuminance", ev_of_illuminance, (single(2.5 * (1 + rng.choice([-1, 1]) * 2.0 ** -rng.randint(1, 20))),)


def main():
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "reference.csv")
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("# Measures of light shapes to 50 digits, written by reference.py (mpmath). Angles in radians.\n")
        out.write("form,argument 1,argument 2,argument 3,value\n")
        for name, form, arguments in cases():
            assert all(x == single(x) for x in arguments)
            texts = [repr(x) for x in arguments] + [""] * (3 - len(arguments))
            out.write(",".join([name] + texts + [nstr(form(*[mpf(x) for x in arguments]), 50)]) + "\n")


if __name__ == "__main__":
    main()
