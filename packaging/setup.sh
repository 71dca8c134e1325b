# Sourced by run, test and .ci/run: installs missing packages, configures and builds. Expects $top.

# missing_packages KIND: packages of packages.txt that dpkg does not report as installed; those that are marked, only
# when KIND is their mark.
missing_packages() {
  local kind=$1 wanted
  mapfile -t wanted < <(awk -v kind="$kind" '!/^#/ && NF && (NF == 1 || $2 == kind) { print $1 }' "$top/packaging/packages.txt")
  local have
  have=$(dpkg-query -W -f '${db:Status-Status} ${binary:Package}\n' 2>/dev/null | sed -n 's/^installed \([^:]*\).*/\1/p')
  local package
  for package in "${wanted[@]}"; do
    grep -qxF -- "$package" <<<"$have" || printf '%s\n' "$package"
  done
}

# ensure_packages [KIND]
ensure_packages() {
  # The stamp spares the question to dpkg on every start; it is void when the list or dpkg's state changes.
  local kind=${1:-build}
  local stamp="$top/build/packages-$kind.stamp"
  if [ -e "$stamp" ] && [ "$stamp" -nt "$top/packaging/packages.txt" ] && [ "$stamp" -nt /var/lib/dpkg/status ]; then
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$kind")
  if [ ${#missing[@]} -gt 0 ]; then
    echo "Installing: ${missing[*]}" >&2
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
      command -v sudo >/dev/null || { echo "These packages are missing and there is no sudo: ${missing[*]}" >&2; exit 3; }
      as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -qq >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
  fi
  mkdir -p "$top/build"
  touch "$stamp"
}

# build_preset PRESET TARGET [CMAKE_OPTION]: configures once (and again for an option that is not set yet), then
# builds. Nothing is printed where nothing is to be done, progress on a terminal, and all that the compiler says when
# it fails. With MAPWRIGHT_WERROR=ON warnings of the compiler are errors.
build_preset() {
  local preset=$1 target=$2 option=${3:-} dir="$top/build/$1" log="$top/build/$1.log"
  mkdir -p "$dir"
  local wanted=(${MAPWRIGHT_WERROR:+"-DMAPWRIGHT_WERROR=$MAPWRIGHT_WERROR"} ${option:+"$option"})
  local configure=0 each name
  [ -e "$dir/build.ninja" ] || configure=1
  for each in "${wanted[@]}"; do
    name=${each%%=*}
    grep -qs "^${name#-D}:.*=${each#*=}$" "$dir/CMakeCache.txt" || configure=1
  done
  if [ $configure = 1 ]; then
    echo "Configuring ($preset) …" >&2
    (cd "$top" && cmake --preset "$preset" "${wanted[@]}") >"$log" 2>&1 || { cat "$log" >&2; exit 3; }
  fi
  NINJA_STATUS='[%f/%t] ' ninja -C "$dir" "$target" 2>&1 | show_build "$preset" "$log" || { cat "$log" >&2; exit 3; }
}

# show_build PRESET LOG: reads what ninja says into LOG. Its look for new sources happens each time and is no building.
show_build() {
  local preset=$1 log=$2 line said= percent=
  exec 3>"$log"
  while IFS= read -r line; do
    printf '%s\n' "$line" >&3
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\ (.*)$ && ${BASH_REMATCH[3]} != 'Re-checking globbed directories'* ]] || continue
    if [ -t 2 ]; then
      [ "$percent" = $((100 * BASH_REMATCH[1] / BASH_REMATCH[2])) ] && continue
      percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
      printf '\rBuilding (%s): %d of %d steps, %d %%' "$preset" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" "$percent" >&2
    elif [ -z "$said" ]; then
      echo "Building ($preset) …" >&2
    fi
    said=1
  done
  if [ -n "$said" ] && [ -t 2 ]; then echo >&2; fi
  exec 3>&-
}
