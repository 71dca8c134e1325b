# Sourced by run, test and .ci/run: installs missing packages, configures and builds. Expects $top.

# Packages of packages.txt that dpkg does not report as installed.
missing_packages() {
  local wanted
  mapfile -t wanted < <(grep -v '^#' "$top/packaging/packages.txt")
  local have
  have=$(dpkg-query -W -f '${db:Status-Status} ${binary:Package}\n' 2>/dev/null | sed -n 's/^installed \([^:]*\).*/\1/p')
  local package
  for package in "${wanted[@]}"; do
    grep -qxF -- "$package" <<<"$have" || printf '%s\n' "$package"
  done
}

ensure_packages() {
  # The stamp spares the question to dpkg on every start; it is void when the list or dpkg's state changes.
  local stamp="$top/build/packages.stamp"
  if [ -e "$stamp" ] && [ "$stamp" -nt "$top/packaging/packages.txt" ] && [ "$stamp" -nt /var/lib/dpkg/status ]; then
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages)
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

# build_preset PRESET TARGET: configures once, builds quietly; what the compiler says is shown when it fails.
build_preset() {
  local preset=$1 target=$2 dir="$top/build/$1" log="$top/build/$1.log"
  mkdir -p "$dir"
  if [ ! -e "$dir/build.ninja" ]; then
    echo "Configuring ($preset) …" >&2
    (cd "$top" && cmake --preset "$preset") >"$log" 2>&1 || { cat "$log" >&2; exit 3; }
  fi
  # Nothing to do is the common case: then nothing is printed.
  if ! ninja -C "$dir" -n "$target" 2>/dev/null | grep -q 'no work to do'; then
    echo "Building ($preset) …" >&2
    ninja -C "$dir" "$target" >"$log" 2>&1 || { cat "$log" >&2; exit 3; }
  fi
}
