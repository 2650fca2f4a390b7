#!/usr/bin/env bash
# The page of `report` in a browser without a network: no message on its console, what is shown, the
# keys, 10 000 joins.
. "$(dirname "$0")/functions.sh"

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  trap - EXIT
  echo "skipped: there is no Chromium"
  exit 77
}

# open PAGE: loads it, runs its timers for some seconds of its own clock, and keeps its document in
# the file dom
open() {
  checks=$((checks + 1))
  timeout 60 "$browser" --headless --no-sandbox --disable-gpu --disable-extensions --no-first-run --user-data-dir="$PWD/profile" \
    --host-resolver-rules='MAP * ~NOTFOUND' --window-size=1400,950 --enable-logging=stderr --virtual-time-budget=5000 --dump-dom \
    "file://$PWD/$1" >dom 2>log </dev/null && ! grep CONSOLE log && return
  failures=$((failures + 1))
  echo "the browser fails on $1"
}
# asks PAGE SCRIPT: opens the page with one more script, whose messages log(text) stand in the file
# answers
asks() {
  { sed "s|script-src '[^']*'|script-src 'unsafe-inline'|" "$1" && cat <<END; } >asked.html
<pre id="answers"></pre>
<script>
const log = (text) => { byId('answers').textContent += '[' + text + ']'; };
const press = (key) => (document.activeElement || document.body).dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
const inked = (canvas) => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.filter((x, i) => i % 4 === 3 && x > 0).length;
$2
</script>
END
  open asked.html
  sed -n '/<pre id="answers">/,/<\/pre>/p' dom >answers
}
rows() { grep -o 'role="option"' dom | wc -l; }
few_rows() { [ "$(rows)" -ge 2 ] && [ "$(rows)" -le 12 ]; }

# a chain of 10 001 cubics, of which each handle is off
awk 'BEGIN {
  for (i = 0; i <= 10000; ++i) printf "100 1 0 0\n2 0\n4 4\n0 0 0 0 1 1 1 1\n%d 0\n%d %d\n%d %d\n%d 0\n", 30 * i, 30 * i + 10, i * i % 7 - 3,
    30 * i + 20, i % 5 - 2, 30 * i + 30
}' >long.g2
run 0 report long.g2 -o long.html --title 'Ten <thousand> joins'
holds [ "$(wc -c <long.html)" -lt 8000000 ]
open long.html && holds few_rows
says dom '<title>Ten &lt;thousand&gt; joins</title>' 'aria-setsize="10000"' 'id="join-0"' $'10\u202f000 shown'
asks long.html '
for (let i = 0; i < 40; ++i) { list.box.scrollTop = (i * 7919 % 10000) * list.pitch; list.render(); }
log("few " + (document.querySelectorAll(".join").length < 12));
log("last " + [...list.rows.keys()].includes(Math.floor(39 * 7919 % 10000)));
const start = performance.now();
for (let i = 0; i < 50; ++i) { list.box.scrollTop = (i * 7919 % 10000) * list.pitch; list.render(); }
log("scrolled " + (performance.now() - start < 10000));
byId("sort").value = "order"; byId("sort").dispatchEvent(new Event("change"));
log("first by order " + items[list.shown[0]].number + " " + items[list.shown[9999]].number);
'
says answers '[few true]' '[last true]' '[scrolled true]' '[first by order 1 10000]'
holds few_rows

# the buttons of the grades count what the list holds, and say what it does not
run 0 report long.g2 -o few.html --worst 20
counted=$(sed -n 's/.*"corner":\([0-9]*\),.*"G1":\([0-9]*\),.*/\1 \2/p' few.html) corners=${counted% *} g1=${counted#* }
asks few.html '
const plain = (text) => text.replace(/\u202f/g, "");
for (const b of document.querySelectorAll("#grades button")) log(plain(b.textContent) + (b.disabled ? " off" : "") + " " + plain(b.title));
log("shown " + byId("shown").textContent);
'
says answers "[corner20of $corners $((corners - 20)) of them are not in the list]" "[G10of $g1 off $g1 of them are not in the list]" '[shown 20 shown]'
asks long.html 'log([...document.querySelectorAll("#grades button")].every((b) => !b.disabled && !b.title && !b.querySelector("small")));'
says answers '[true]'

# drawings, keys, filter and sort
svg '<path id="&lt;script>alert(1)&lt;/script>" d="M0 0C100 0 200 0 300 0C400 1 500 100 600 200V400L0 400z"/>
<path id="round" d="M10 10a50 50 0 1 1 100 0C110 60 80 90 60 90"/>'
run 0 report drawing.svg -o drawing.html && open drawing.html
says dom 'path "&lt;script&gt;alert(1)&lt;/script&gt;" (line 2), subpath 1'
asks drawing.html '
log("inked " + items.map((_, i) => document.querySelector("#join-" + i + " canvas")).filter((c) => c).every((c) => inked(c) > 500));
log(items[list.shown[list.position]].grade + " chosen");
press("j"); press("ArrowDown"); press("k"); log("row " + list.position);
press("End"); log("end " + (list.position === items.length - 1)); press("Home"); log("home " + list.position);
press("/"); log("focus " + document.activeElement.id);
byId("filter").value = "round CORNER"; byId("filter").dispatchEvent(new Event("input"));
log("filtered " + list.shown.every((i) => items[i].place.includes("round") && items[i].grade === "corner"));
byId("filter").value = "no such"; byId("filter").dispatchEvent(new Event("input")); log("empty " + !byId("empty").hidden + list.shown.length);
byId("filter").value = ""; byId("filter").dispatchEvent(new Event("input"));
press("j"); log("typing " + list.position); press("Escape"); log("back " + document.activeElement.id);
document.querySelector("#grades .kink").click(); log("without kinks " + list.shown.every((i) => items[i].grade !== "kink"));
document.querySelector("#grades .kink").click(); log("all " + (list.shown.length === items.length));
press("s"); log("sorted by " + list.order); press("s"); log("angles " + list.shown.map((i) => upperBound(items[i].angle)).every((x, i, a) => i === 0 || x <= a[i - 1]));
list.order = "worst"; list.update(); list.box.focus(); press("Home");
press("Enter"); log("large " + large.box.open + (inked(large.canvas) > 2000)); press("+"); press("j"); log("next " + list.position + large.zoom);
large.box.close();
const dark = document.documentElement.classList.contains("dark"); press("t"); log("other theme " + (dark !== document.documentElement.classList.contains("dark")));
press("?"); log("keys " + byId("keys").open); byId("keys").close();
'
says answers '[inked true]' '[kink chosen]' '[row 1]' '[end true]' '[home 0]' '[focus filter]' '[filtered true]' '[empty true0]' '[typing 0]' \
  '[back list]' '[without kinks true]' '[all true]' '[sorted by order]' '[angles true]' '[large truetrue]' '[next 11]' '[other theme true]' '[keys true]'

# joins are linked to a page where their points are dragged, their numbers as they are
run 0 report drawing.svg -o linked.html --page 'my pages/joins.html' && asks linked.html '
for (const i of items) log(i.grade + (i.left.link && i.right.link ? "" : " arc") + " " + (linkOf(i)[0]?.getAttribute("href") ?? "none"));
log(document.querySelectorAll(".join a.link").length > 0);
'
says answers '[kink my pages/joins.html#join?left=0,0;100,0;200,0;300,0&amp;right=300,0;400,1;500,100;600,200]' '[true]' ' arc none]'
asks drawing.html 'log("links " + document.querySelectorAll("a").length + items.flatMap(linkOf).length);'
says answers '[links 00]'
printf '<svg xmlns="http://www.w3.org/2000/svg"><path transform="matrix(.3 0 0 1 0.1 0)" d="M0 0C1 0 2 0 3 0Q4 1 5 1"/></svg>' >decimals.svg
run 0 report decimals.svg -o decimals.html --page p.html && asks decimals.html 'log(linkOf(items[0])[0].getAttribute("href"));'
says answers '[p.html#join?left=1/10,0;2/5,0;7/10,0;1,0&amp;right=1,0;13/10,1;8/5,1]'
printf '100 1 0 0\n2 1\n3 3\n0 0 0 2 2 2\n0 0 1\n1 0 1\n1 1 2\n100 1 0 0\n2 0\n2 2\n0 0 1 1\n.5 .5\n.5 2\n' >weighted.g2
run 0 report weighted.g2 -o weighted.html --page p.html && asks weighted.html 'log(linkOf(items[0])[0].getAttribute("href"));'
says answers '[p.html#join?left='

# fonts have grades of their own, and no others
cat >glyphs.txt <<'END'
glyph .notdef
glyph off 65
contour 0,0 300,20 600,20 900,0 600,-500 300,-500
contour 2000,0 2100,0 2200,7* 2300,300 2000,300
contour 3000,0 3100,0 3200,1 3200,300 3000,300
END
font test.ttf <glyphs.txt
run 0 report test.ttf -o font.html && asks font.html '
const root = getComputedStyle(document.documentElement);
for (const b of document.querySelectorAll("#grades button")) log(b.textContent);
log("coloured " + gradeNames.every((g) => root.getPropertyValue("--" + g) && colours[g] === root.getPropertyValue("--" + g).trim()));
log([...document.querySelectorAll(".join")].slice(0, 2).map((j) => [...j.querySelectorAll("dt")].map((d) => d.textContent)[2]).join());
'
says answers '[kink1][bend2][rounding1][corner11][coloured true][Handle is off by,Off by]'

# surfaces: the model turns
run 0 report --surfaces "$teapot" -o teapot.html && open teapot.html
says dom 'class="with-model"' 'aria-setsize="52"'
asks teapot.html '
const canvas = document.querySelector("#model canvas");
drawModel(canvas, model, { camera, frame: model.frame, patches: model.all, chosen: 0, fill: true });
log("inked " + (inked(canvas) > 20000) + [...document.querySelectorAll(".join canvas")].every((c) => inked(c) > 1000));
canvas.focus(); const azimuth = camera.azimuth, row = list.position;
press("ArrowLeft"); press("ArrowUp"); press("+"); log("turned " + (camera.azimuth !== azimuth && camera.zoom > 1) + (row === list.position));
list.box.focus(); press("ArrowDown"); log("row " + list.position);
const numbers = [...document.querySelectorAll("dl.numbers dd")];
for (const d of numbers) d.textContent = "(7.23172, 3.14095, 0.475283) ≤ 0.000230417 ≥ 0.000229072 parameter 0.20129 of a long row";
log("whole " + (numbers.length > 0 && numbers.every((d) => d.scrollWidth <= d.clientWidth && d.getBoundingClientRect().bottom <= d.closest(".join").getBoundingClientRect().bottom)));
'
says answers '[inked truetrue]' '[turned truetrue]' '[row 1]' '[whole true]'

# a drawing: no number of a card is cut off
run 0 report "$data/leaf_inkscape.svg" -o leaf.html && asks leaf.html '
const all = [...document.querySelectorAll("dl.numbers dd")];
log("whole " + (all.some((d) => d.textContent.includes("‰")) && all.every((d) => d.scrollWidth <= d.clientWidth)));
'
says answers '[whole true]'

# in space, and no join at all
run 0 report "$L" --closed -o space.html && asks space.html 'log("inked " + (inked(document.querySelector(".join canvas")) > 500));'
says answers '[inked true]'
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h1"/></svg>' >drawing.svg
run 0 report drawing.svg -o none.html && open none.html && says dom 'There is no join.'
rm -rf profile
