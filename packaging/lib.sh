# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# Shared by the scripts beside it; sourced, with $root set to the top of the project.
: "${root:?}"

# say WORDS…: one line about what is going on, apart from what the tools print.
say() { printf '\n== %s\n' "$*" >&2; }

# fail SENTENCE: says why and ends.
fail() { printf '\n!! %s\n' "$*" >&2; exit 1; }

# packages LIST…: the names in packaging/packages/LIST.txt.
packages() {
    local list
    for list in "$@"; do
        sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$root/packaging/packages/$list.txt"
    done
}

# missing_packages LIST…: those of them that are not installed.
missing_packages() {
    local name
    packages "$@" | while read -r name; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || printf '%s\n' "$name"
    done
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "Packages must be installed and there is no sudo. As root: apt-get install $(missing_packages build run test | tr '\n' ' ')"
    fi
}

# install_packages LIST…: installs what is missing; costs nothing when nothing is.
install_packages() {
    command -v apt-get >/dev/null ||
        fail "This is not a Debian system. Install by other means what packaging/packages names, then use cmake --preset release."
    local missing
    missing=$(missing_packages "$@")
    [ -z "$missing" ] && return
    say "Installing $(printf '%s\n' "$missing" | wc -l) Debian packages: $(printf '%s' "$missing" | tr '\n' ' ')"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
    # shellcheck disable=SC2086 # one word a package
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
}

# What was compiled once is not compiled again, in no other clone either; the cache is the user's own.
export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_PCH_EXTSUM=1
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_ctime,include_file_mtime

# configure PRESET [OPTION…]: once; later only where an option changes.
configure() {
    local preset=$1
    shift
    say "Configuring build/$preset"
    (cd "$root" && cmake --preset "$preset" "$@" >"$root/build-$preset.log" 2>&1) || {
        cat "$root/build-$preset.log" >&2
        fail "The configuration of build/$preset failed; the lines above say why."
    }
    mv "$root/build-$preset.log" "$root/build/$preset/configure.log"
}

# build PRESET [TARGET…]
build() {
    local preset=$1
    shift
    say "Building build/$preset (the first time takes some minutes)"
    if [ "$#" -gt 0 ]; then
        cmake --build "$root/build/$preset" --target "$@"
    else
        cmake --build "$root/build/$preset"
    fi
}

# start_of_changes: the commit where this branch left main; on main itself the twentieth before.
start_of_changes() {
    local head base
    head=$(git -C "$root" rev-parse HEAD)
    base=$(git -C "$root" merge-base origin/main HEAD 2>/dev/null || true)
    if [ -z "$base" ] || [ "$base" = "$head" ]; then
        base=$(git -C "$root" rev-list --max-count=21 HEAD | tail -n 1)
    fi
    printf '%s\n' "$base"
}
