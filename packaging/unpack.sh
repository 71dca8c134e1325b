#!/bin/sh
# Run by the .run file where it has unpacked itself: puts mapwright into a folder (default ~/.local/opt) and installs it for
# this user. --only-unpack leaves the menu alone.
#   mapwright-….run -- [--only-unpack] [FOLDER]
set -eu
only=
if [ "${1:-}" = --only-unpack ]; then only=1; shift; fi
into=${1:-${HOME:+$HOME/.local/opt}}
[ -n "$into" ] || { echo "There is no home folder. Name one to unpack into: -- --only-unpack FOLDER" >&2; exit 2; }
case $into in /*) ;; *) into=${USER_PWD:-$PWD}/$into ;; esac
mkdir -p -- "$into"
name=$(tar -tJf archive.tar.xz | head -n 1)
name=${name%%/*}
[ ! -e "$into/$name" ] || { echo "$into/$name is there already." >&2; exit 2; }
tar -xJf archive.tar.xz -C "$into"
if [ -n "$only" ]; then echo "$into/$name/bin/mapwright"; else "$into/$name/install.sh"; fi
