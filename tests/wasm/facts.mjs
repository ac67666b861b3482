// What `gonio info --json` says without the figures of a luminaire, which the core module does not have.
export function withoutFigures(report) {
  const keys = Object.keys(report);
  const first = keys.indexOf('light_output_ratios');
  const last = keys.indexOf('missing_figures');
  if (first < 0 || last < first) throw new Error('the report has no figures');
  return Object.fromEntries(keys.filter((_, i) => i < first || i > last).map((key) => [key, report[key]]));
}
