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

# build_preset PRESET TARGET [CMAKE_OPTION]: configures once (and again for an option that is not set yet), builds
# quietly; what the compiler says is shown when it fails.
build_preset() {
  local preset=$1 target=$2 option=${3:-} dir="$top/build/$1" log="$top/build/$1.log"
  mkdir -p "$dir"
  local name=${option%%=*}
  if [ ! -e "$dir/build.ninja" ] || { [ -n "$option" ] && ! grep -q "^${name#-D}:.*=${option#*=}$" "$dir/CMakeCache.txt"; }; then
    echo "Configuring ($preset) …" >&2
    (cd "$top" && cmake --preset "$preset" ${option:+"$option"}) >"$log" 2>&1 || { cat "$log" >&2; exit 3; }
  fi
  # Nothing to do is the common case: then nothing is printed.
  if ! ninja -C "$dir" -n "$target" 2>/dev/null | grep -q 'no work to do'; then
    echo "Building ($preset) …" >&2
    ninja -C "$dir" "$target" >"$log" 2>&1 || { cat "$log" >&2; exit 3; }
  fi
}
