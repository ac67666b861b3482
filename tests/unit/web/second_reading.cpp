#include "second_reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <sstream>

namespace gonio::test {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

using Column = std::vector<double>;

std::vector<std::string> lines_of(const std::string& bytes) {
    std::vector<std::string> lines{""};
    for (std::size_t i = 0; i < bytes.size() && bytes[i] != '\x1A'; ++i) {
        if (bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n') continue;
        if (bytes[i] == '\n' || bytes[i] == '\r')
            lines.emplace_back();
        else
            lines.back() += bytes[i];
    }
    return lines;
}

// Planes at all angles; if several images give the same plane, the first one is kept.
SecondReading of_planes(const std::vector<double>& gammas, const std::vector<std::pair<double, Column>>& planes) {
    std::map<double, Column> sorted;
    for (const auto& [c, column] : planes)
        sorted.emplace(c, column);
    SecondReading reading;
    reading.vertical_deg = gammas;
    for (const auto& [c, column] : sorted) {
        reading.horizontal_deg.push_back(c);
        reading.candela.push_back(column);
    }
    // If the last plane is left out, it is the first one, a turn later.
    if (reading.horizontal_deg.size() > 1) {
        double widest = 0.0;
        for (std::size_t i = 1; i < reading.horizontal_deg.size(); ++i)
            widest = std::max(widest, reading.horizontal_deg[i] - reading.horizontal_deg[i - 1]);
        const double gap = 360.0 - (reading.horizontal_deg.back() - reading.horizontal_deg.front());
        if (gap > 1e-6 && gap < widest + 1e-3) {
            reading.horizontal_deg.push_back(reading.horizontal_deg.front() + 360.0);
            reading.candela.push_back(reading.candela.front());
        }
    }
    return reading;
}

// If rows repeat an angle, the first one is used.
void drop_repeated_rows(std::vector<double>& gammas, std::vector<Column>& columns) {
    for (std::size_t j = gammas.size(); j-- > 1;)
        if (gammas[j] == gammas[j - 1]) {
            gammas.erase(gammas.begin() + static_cast<std::ptrdiff_t>(j));
            for (Column& column : columns)
                column.erase(column.begin() + static_cast<std::ptrdiff_t>(j));
        }
}

SecondReading of_ies(const std::vector<std::string>& lines, std::size_t tilt_line) {
    std::string text;
    for (std::size_t i = tilt_line + 1; i < lines.size(); ++i)
        text += lines[i] + ' ';
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream tokens(text);
    const auto next = [&] {
        std::string token;
        tokens >> token;
        return std::strtod(token.c_str(), nullptr);
    };
    double factor = 1.0;
    if (lines[tilt_line].find("INCLUDE") != std::string::npos) {
        next(); // geometry
        const auto count = static_cast<std::size_t>(next());
        std::vector<double> angles(count);
        for (double& angle : angles)
            angle = next();
        for (const double angle : angles) {
            const double at = next();
            if (angle == 0.0) factor = at; // the lamp in the position it was measured in; files list it
        }
    }
    double header[13];
    for (double& value : header)
        value = next();
    const std::string& version = lines[0];
    const bool old = version.find("91") != std::string::npos || version.find("86") != std::string::npos ||
                     version.find("IES") == std::string::npos;
    factor *= header[2] * header[10] * (old ? header[11] : 1.0);
    std::vector<double> v(static_cast<std::size_t>(header[3]));
    std::vector<double> h(static_cast<std::size_t>(header[4]));
    for (double& angle : v)
        angle = next();
    for (double& angle : h)
        angle = next();
    std::vector<Column> columns(h.size(), Column(v.size()));
    for (Column& column : columns)
        for (double& cd : column)
            cd = next() * factor;
    drop_repeated_rows(v, columns);

    std::vector<std::pair<double, Column>> planes;
    for (std::size_t i = 0; i < h.size(); ++i)
        planes.emplace_back(h[i], columns[i]);
    const std::size_t stored = planes.size();
    if (header[5] == 1.0) {
        if (stored == 1) return of_planes(v, {{0.0, columns[0]}, {360.0, columns[0]}});
        const double first = h.front();
        const double last = h.back();
        for (std::size_t i = 0; i < stored; ++i) {
            const double c = h[i];
            const Column& column = columns[i];
            if (first == 0.0 && last == 90.0) {
                for (const double image : {180.0 - c, 180.0 + c, 360.0 - c})
                    planes.emplace_back(image, column);
            } else if (first == 0.0 && last == 180.0) {
                planes.emplace_back(360.0 - c, column);
            } else if (first == 90.0 && last == 270.0) {
                const double image = c <= 180.0 ? 180.0 - c : 540.0 - c;
                planes.emplace_back(image, column);
                if (c == 180.0) planes.emplace_back(360.0, column);
            }
        }
        return of_planes(v, planes);
    }
    // Types A and B: H or V that start at 0 describe both sides.
    SecondReading reading;
    reading.type = header[5] == 2.0 ? 'B' : 'A';
    std::map<double, std::map<double, double>> table;
    for (std::size_t i = 0; i < h.size(); ++i)
        for (std::size_t j = 0; j < v.size(); ++j)
            for (const double across : {1.0, h.front() == 0.0 ? -1.0 : 1.0})
                for (const double along : {1.0, v.front() == 0.0 ? -1.0 : 1.0})
                    table[across * h[i] + 0.0][along * v[j] + 0.0] = columns[i][j];
    for (const auto& [at, column] : table) {
        reading.horizontal_deg.push_back(at);
        reading.candela.emplace_back();
        reading.vertical_deg.clear();
        for (const auto& [angle, cd] : column) {
            reading.vertical_deg.push_back(angle);
            reading.candela.back().push_back(cd);
        }
    }
    return reading;
}

SecondReading of_ldt(const std::vector<std::string>& lines) {
    const auto number = [&](std::size_t line) { // 1-based, as EULUMDAT's description counts
        std::string text = line <= lines.size() ? lines[line - 1] : "";
        std::replace(text.begin(), text.end(), ',', '.');
        return std::strtod(text.c_str(), nullptr);
    };
    const int symmetry = static_cast<int>(number(3));
    const auto planes = static_cast<std::size_t>(number(4));
    const auto rows = static_cast<std::size_t>(number(6));
    const auto sets = static_cast<std::size_t>(number(26));
    const double factor = number(24) * number(29) / 1000.0; // line 24: conversion factor; 29: flux of the first set
    std::size_t at = 27 + 6 * sets + 10;
    std::vector<double> c(planes);
    std::vector<double> gammas(rows);
    for (double& angle : c)
        angle = number(at++);
    for (double& angle : gammas)
        angle = number(at++);
    std::size_t last = lines.size();
    while (last > 0 && lines[last - 1].find_first_of("0123456789") == std::string::npos)
        --last;
    const std::size_t left = (last + 1 - at) / rows; // planes that the file holds
    std::vector<Column> columns(std::min(left, planes), Column(rows));
    for (Column& column : columns)
        for (double& cd : column)
            cd = number(at++) * factor;
    drop_repeated_rows(gammas, columns);
    const auto stored_at = [&](double angle) -> const Column& { // of a list that begins at C0
        const auto found = std::find(c.begin(), c.end(), angle);
        return columns.at(static_cast<std::size_t>(found - c.begin()));
    };
    std::vector<std::pair<double, Column>> all;
    // One plane stands for every C, also where a file forgot to say so: their IES twins are round.
    const bool round = symmetry == 1 || (symmetry == 0 && planes == 1);
    if (round && columns.size() < planes + 1 && !columns.empty())
        return of_planes(gammas, {{0.0, columns[0]}, {360.0, columns[0]}});
    for (std::size_t i = 0; i < planes; ++i) {
        double angle = c[i];
        if (symmetry == 0 || columns.size() == planes) {
            all.emplace_back(angle, columns[i]);
            if (columns.size() == planes && symmetry != 0) { // the mirrored half is not listed
                all.emplace_back(360.0 - angle, columns[i]);
                if (symmetry == 4) all.emplace_back(180.0 - angle, columns[i]);
                if (symmetry == 4) all.emplace_back(180.0 + angle, columns[i]);
            }
        } else if (symmetry == 3) {
            // Stored: C270 over C0 to C90. The others are images in the C90–C270 plane.
            if (angle > 90.0 && angle < 270.0) angle = std::fmod(540.0 - angle, 360.0);
            const auto first = std::find(c.begin(), c.end(), 270.0) - c.begin();
            const auto here = std::find(c.begin(), c.end(), angle) - c.begin();
            const auto count = static_cast<std::ptrdiff_t>(planes);
            all.emplace_back(c[i], columns.at(static_cast<std::size_t>((here - first + count) % count)));
        } else {
            if (angle > 180.0) angle = 360.0 - angle;
            if (symmetry == 4 && angle > 90.0) angle = 180.0 - angle;
            all.emplace_back(c[i], stored_at(angle));
        }
    }
    return of_planes(gammas, all);
}

// Five points, exact for polynomials of degree 9: on cells of a few degrees far below 1e-12.
template<class Integrand>
double integral(double low, double high, Integrand f) {
    constexpr double x[] = {0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
    constexpr double w[] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                            0.2369268850561891};
    const int pieces = 1 + static_cast<int>((high - low) / 5.0);
    const double half = 0.5 * (high - low) / pieces;
    double sum = 0.0;
    for (int piece = 0; piece < pieces; ++piece)
        for (int k = 0; k < 5; ++k)
            sum += w[k] * f(low + (2 * piece + 1 + x[k]) * half);
    return sum * half;
}

// The cell of `angle` and how far it is within it; false outside.
bool find_cell(const std::vector<double>& angles, double angle, std::size_t& cell, double& part) {
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        if (angle >= angles[i] && angle <= angles[i + 1]) {
            cell = i;
            part = (angle - angles[i]) / (angles[i + 1] - angles[i]);
            return true;
        }
    return false;
}

} // namespace

double SecondReading::peak_cd() const {
    double peak = candela[0][0];
    for (const Column& column : candela)
        for (const double cd : column)
            peak = std::max(peak, cd);
    return peak;
}

double SecondReading::flux_lm() const {
    // Solid angle: sin γ of type C; cosine of the latitude, which is V in type A and H in type B.
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < horizontal_deg.size(); ++i)
        for (std::size_t j = 0; j + 1 < vertical_deg.size(); ++j)
            sum += integral(horizontal_deg[i], horizontal_deg[i + 1], [&](double h) {
                const double s = (h - horizontal_deg[i]) / (horizontal_deg[i + 1] - horizontal_deg[i]);
                return integral(vertical_deg[j], vertical_deg[j + 1], [&](double v) {
                    const double t = (v - vertical_deg[j]) / (vertical_deg[j + 1] - vertical_deg[j]);
                    const double cd = (1 - s) * ((1 - t) * candela[i][j] + t * candela[i][j + 1]) +
                                      s * ((1 - t) * candela[i + 1][j] + t * candela[i + 1][j + 1]);
                    return cd * (type == 'C'   ? std::sin(v * degree)
                                 : type == 'A' ? std::cos(v * degree)
                                               : std::cos(h * degree));
                });
            });
    return sum * degree * degree;
}

double SecondReading::candela_along(double x, double y, double z) const {
    double h = std::atan2(y, x) / degree;
    double v = std::acos(-z) / degree;
    if (type == 'A') {
        h = std::atan2(x, -z) / degree;
        v = std::asin(y) / degree;
    } else if (type == 'B') {
        h = std::asin(x) / degree;
        v = std::atan2(y, -z) / degree;
    }
    for (const double turn : {0.0, 360.0, -360.0}) {
        std::size_t i = 0;
        std::size_t j = 0;
        double s = 0.0;
        double t = 0.0;
        if (turn != 0.0 && type != 'C') break;
        if (find_cell(horizontal_deg, h + turn, i, s) && find_cell(vertical_deg, v, j, t))
            return (1 - s) * ((1 - t) * candela[i][j] + t * candela[i][j + 1]) +
                   s * ((1 - t) * candela[i + 1][j] + t * candela[i + 1][j + 1]);
    }
    return 0.0;
}

SecondReading second_reading(const std::string& bytes) {
    const std::vector<std::string> lines = lines_of(bytes);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::string text = lines[i];
        std::erase(text, ' ');
        if (text.rfind("TILT=", 0) == 0) return of_ies(lines, i);
    }
    return of_ldt(lines);
}

} // namespace gonio::test
