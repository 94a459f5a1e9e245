# Menu entry, file types and software centre data are valid.
set -euo pipefail
source_dir=$2 build=$3
id=org.feedscope.Feedscope
for tool in desktop-file-validate appstreamcli; do
  command -v $tool >/dev/null || { echo "$tool is not installed: skipped"; exit 77; }
done
desktop-file-validate "$source_dir/packaging/desktop/$id.desktop"
appstreamcli validate --no-net "$build/$id.metainfo.xml"
python3 - "$source_dir/packaging/desktop/$id.xml" "$source_dir/resources/icons/feedscope.svg" <<'PY'
import sys, xml.etree.ElementTree as tree
types = tree.parse(sys.argv[1]).getroot()
names = [entry.get("type") for entry in types]
assert "application/x-feedscope-session" in names, names
assert tree.parse(sys.argv[2]).getroot().tag.endswith("svg")
PY
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
grep -q "<release version=\"$version\"" "$build/$id.metainfo.xml" || { echo "no release notes of version $version"; exit 1; }
grep -q "^## $version" "$source_dir/packaging/CHANGELOG.md" || { echo "no changelog of version $version"; exit 1; }
