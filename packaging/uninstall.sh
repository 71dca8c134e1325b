#!/bin/sh
# uninstall.sh: takes back what install.sh of this folder did. The folder itself, and settings and drafts, stay.
set -eu
here=$(cd -- "$(dirname -- "$0")" && pwd -P)
[ -n "${HOME:-}" ] || { echo "There is no home folder." >&2; exit 2; }
data=${XDG_DATA_HOME:-$HOME/.local/share}
entry=$data/applications/mapwright.desktop
if grep -qxF "X-Mapwright-Folder=$here" "$entry" 2>/dev/null; then
  rm -f "$entry" "$data/icons/hicolor/scalable/apps/mapwright.svg" "$data/mime/packages/mapwright.xml"
  if command -v update-desktop-database >/dev/null; then update-desktop-database -q "$data/applications" || true; fi
  if command -v update-mime-database >/dev/null; then update-mime-database "$data/mime" >/dev/null 2>&1 || true; fi
elif [ -e "$entry" ]; then
  echo "The entry in the menu is that of another folder and stays." >&2
fi
link=$HOME/.local/bin/mapwright
if [ "$(readlink "$link" 2>/dev/null)" = "$here/bin/mapwright" ]; then rm "$link"; fi
echo "mapwright is no longer in the menu. Delete $here to remove it. Settings and drafts stay."
