# The least and the largest time of each row of several runs, and of its ratio to the first row of
# the same work within a run. Reads JSON with one member a line; rows are named WORK | METHOD.
# Writes NAME, times, unit, ratios, separated by tabs.
function row() {
  if (name ~ / \| / && !aggregate) {
    cut = match(name, / \| [^|]*$/)
    what = substr(name, 1, cut - 1)
    if (items > 0) { time = 1e9 / items; unit = "ns" }
    if (!(what in first) || name == first_name[what]) { first[what] = time; first_name[what] = name }
    ratio = time / first[what]
    if (!(name in low)) { order[++n] = name; low[name] = high[name] = time; low_x[name] = high_x[name] = ratio; units[name] = unit }
    if (time < low[name]) low[name] = time
    if (time > high[name]) high[name] = time
    if (ratio < low_x[name]) low_x[name] = ratio
    if (ratio > high_x[name]) high_x[name] = ratio
  }
  name = ""; items = 0; aggregate = 0
}
function value() { sub(/^[^:]*: */, ""); sub(/[,}\]]*$/, ""); gsub(/"/, ""); return $0 }
/^ *"name":/ { row(); name = value() }
/^ *"run_type": "aggregate"/ { aggregate = 1 }
/^ *"cpu_time":/ { time = value() + 0 }
/^ *"time_unit":/ { unit = value() }
/^ *"items_per_second":/ { items = value() + 0 }
END {
  row()
  for (i = 1; i <= n; ++i) { name = order[i]; printf "%s\t%.4g\t%.4g\t%s\t%.2f\t%.2f\n", name, low[name], high[name], units[name], low_x[name], high_x[name] }
}
