#!/bin/sh
# install.sh [--to FOLDER]: adds mapwright to the menu of the desktop and to ~/.local/bin, for this user. It runs from the
# folder where this file lies, or, with --to, from a copy of it.
set -eu
here=$(cd -- "$(dirname -- "$0")" && pwd -P)
case "${1:-}" in
  "") ;;
  --to)
    [ $# = 2 ] && [ -n "$2" ] || { echo "Which folder? --to FOLDER" >&2; exit 2; }
    if [ -e "$2" ] && { [ ! -d "$2" ] || [ -n "$(ls -A -- "$2")" ]; }; then
      echo "$2 is not an empty folder." >&2
      exit 2
    fi
    mkdir -p -- "$2"
    cp -R -- "$here/." "$2"
    exec "$2/install.sh"
    ;;
  *) echo "Unknown: $1. There is --to FOLDER." >&2; exit 2 ;;
esac
[ -n "${HOME:-}" ] && [ -d "$HOME" ] || { echo "There is no home folder to install into. $here/bin/mapwright runs without." >&2; exit 2; }
data=${XDG_DATA_HOME:-$HOME/.local/share}
mkdir -p "$data/applications" "$data/icons/hicolor/scalable/apps" "$data/mime/packages" "$HOME/.local/bin"
# As the specification of desktop entries wants a path quoted, and that string once more.
quoted=$(printf '%s' "$here/bin/mapwright" | sed -e 's/[\\"`$]/\\&/g' -e 's/\\/\\\\/g' -e 's/%/%%/g')
while IFS= read -r line; do
  case $line in
    Exec=*) printf 'Exec="%s" %%f\nX-Mapwright-Folder=%s\n' "$quoted" "$here" ;;
    *) printf '%s\n' "$line" ;;
  esac
done <"$here/share/applications/mapwright.desktop" >"$data/applications/mapwright.desktop"
cp "$here/share/icons/hicolor/scalable/apps/mapwright.svg" "$data/icons/hicolor/scalable/apps"
cp "$here/share/mime/packages/mapwright.xml" "$data/mime/packages"
if [ -e "$HOME/.local/bin/mapwright" ] && [ ! -L "$HOME/.local/bin/mapwright" ]; then
  echo "$HOME/.local/bin/mapwright is something else and stays." >&2
else
  ln -sfn "$here/bin/mapwright" "$HOME/.local/bin/mapwright"
fi
if command -v update-desktop-database >/dev/null; then update-desktop-database -q "$data/applications" || true; fi
if command -v update-mime-database >/dev/null; then update-mime-database "$data/mime" >/dev/null 2>&1 || true; fi
echo "mapwright is in the menu, and in $HOME/.local/bin. It runs from $here, which must stay there."
