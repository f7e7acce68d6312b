#!/usr/bin/env bash
# Looks at a study's page in headless Chromium: plots drawn, sorting, keyboard, no word on the console,
# no sideways scrolling at 1280 and 400 px; and that a page with a fault is seen.
#   study_page.sh PINEDA STUDY.toml
# Exit code 77 where Chromium or libjs-d3 is not installed.
set -euo pipefail
pineda=$1 study=$2
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")

browser=$(command -v chromium || command -v chromium-browser || true)
[[ -n $browser ]] || { echo "Chromium is not installed"; exit 77; }
[[ -f /usr/share/javascript/d3/d3.min.js ]] || { echo "libjs-d3 is not installed"; exit 77; }

folder=$(mktemp -d -t pineda-page-XXXXXX)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$pineda" study run "$study" --results rows.db --quiet
"$pineda" study report "$study" --results rows.db -o page.html --quiet
if grep -qE '(src|href)="?https?:' page.html; then echo "study_page: the page needs the network"; exit 1; fi

# What is wrong with a page, a line each.
wrong_with() {
  timeout 120 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars \
      --user-data-dir="$folder/browser" --allow-file-access-from-files --enable-logging=stderr \
      --virtual-time-budget=20000 --dump-dom "file://$here/study_page.html#file://$folder/$1" \
      >dom.html 2>log.txt || { echo "the browser failed"; cat log.txt; }
  grep CONSOLE log.txt || true
  grep -q 'looked</pre>' dom.html || echo "the page was not looked at"
  grep -o 'wrong: [^<]*' dom.html || true
}

wrong=$(wrong_with page.html)
if [[ -n $wrong ]]; then echo "study_page: $wrong"; exit 1; fi

# A page whose script is at fault, one that is too wide, and one that does not sort.
sed 's/function draw() {/function draw() { console.error("fault");/' page.html >fault.html
sed 's/<main>/<main style="min-width:500px">/' page.html >wide.html
sed "s/(order.up ? 1 : -1)/0/" page.html >order.html
for fault in fault wide order; do
  cmp -s page.html "$fault.html" && { echo "study_page: expected $fault.html to differ"; exit 1; }
  [[ -n $(wrong_with "$fault.html") ]] || { echo "study_page: $fault.html is not seen"; exit 1; }
done
echo "drawn, sorted, chosen; three faults seen"
