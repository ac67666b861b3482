// The palette viridis of false-colour pictures, at ten places (Smith and van der Walt, 2015), for legends and the solid.
const stops = ['440154', '482878', '3e4a89', '31688e', '26828e', '1f9e89', '35b779', '6ece58', 'b5de2b', 'fde725']
  .map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));

// RGB from 0 to 255, of a place from 0 to 1.
export function viridis(place) {
  const x = Math.min(1, Math.max(0, place)) * (stops.length - 1);
  const i = Math.min(stops.length - 2, Math.floor(x));
  return stops[i].map((value, channel) => value + (x - i) * (stops[i + 1][channel] - value));
}

export const viridisGradient = `linear-gradient(to right, ${stops.map((rgb) => `rgb(${rgb.join(' ')})`).join(', ')})`;
