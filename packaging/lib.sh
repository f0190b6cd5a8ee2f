# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# Shared by the scripts of this folder; sourced, with $root set to the top of the project.
: "${root:?}"

# say WORDS…: one line on progress, set apart from the output of the tools.
say() { printf '\n== %s\n' "$*" >&2; }

# fail SENTENCE: the reason, then the end of the script.
fail() { printf '\n!! %s\n' "$*" >&2; exit 1; }

# interrupted STATUS: the end by Ctrl-C or another signal; every step below continues where it stopped.
interrupted() {
    printf '\n!! Interrupted. Finished work is kept; the same command continues from here.\n' >&2
    exit "$1"
}
trap 'interrupted 129' HUP
trap 'interrupted 130' INT
trap 'interrupted 143' TERM

# cores: the number of processors this process may use.
cores() { nproc 2>/dev/null || getconf _NPROCESSORS_ONLN; }

# packages LIST…: the names in packaging/packages/LIST.txt.
packages() {
    local list
    for list in "$@"; do
        sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$root/packaging/packages/$list.txt"
    done
}

# missing_packages LIST…: the packages of the lists that are not installed.
missing_packages() {
    local name
    packages "$@" | while read -r name; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || printf '%s\n' "$name"
    done
}

# one_line: the words of its input, separated by spaces.
one_line() { tr '\n' ' ' | sed 's/ *$//'; }

# as_root COMMAND…
as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# may_install LIST…: ends the script with a sentence for the administrator where this user cannot become root.
may_install() {
    [ "$(id -u)" -eq 0 ] && return
    local ask
    ask="Ask an administrator to run: apt-get install --no-install-recommends $(missing_packages "$@" | one_line)"
    command -v sudo >/dev/null || fail "Packages are missing, and this system has no sudo. $ask"
    sudo -v || fail "Packages are missing, and sudo does not let this user install them. $ask"
}

# Another program holds the packages for minutes on every fresh Debian: the automatic updates.
lock_wait_s=${TOUCHPHOTO_LOCK_WAIT_S:-600}
lock_poll_s=${TOUCHPHOTO_LOCK_POLL_S:-5}

# apt_get WORDS…: apt-get as root. Waits up to lock_wait_s for other programs that hold the packages, and names them; completes
# an installation that was interrupted.
apt_get() {
    local errors status waited_s=0 completed=
    errors=$(mktemp)
    while :; do
        status=0
        as_root env LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive apt-get -y -q "$@" 2>"$errors" || status=$?
        # apt-get update ends in 0 where another program holds the lists.
        if grep -qE '(Could not get|Unable to acquire the dpkg frontend|frontend) lock|Unable to lock|is locked by another process' "$errors" &&
            { [ "$status" -ne 0 ] || [ "$1" = update ]; }; then
            if [ "$waited_s" -ge "$lock_wait_s" ]; then
                cat "$errors" >&2
                rm -f "$errors"
                fail "Another program still uses the package manager after $((lock_wait_s / 60)) minutes. Run this again when it has finished."
            fi
            [ "$waited_s" -gt 0 ] || say "Waiting up to $((lock_wait_s / 60)) minutes for another program that uses the package manager:" \
                "$(grep -m 1 -oE 'held by process [0-9]+ \([^)]*\)' "$errors" || sed -n '1s/^[EW]: //p' "$errors")"
            sleep "$lock_poll_s"
            waited_s=$((waited_s + (lock_poll_s > 0 ? lock_poll_s : 1)))
        elif [ "$status" -ne 0 ] && [ -z "$completed" ] && grep -q 'dpkg was interrupted' "$errors"; then
            completed=yes
            say "Completing an interrupted installation"
            as_root env LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive dpkg --configure -a
        else
            break
        fi
    done
    cat "$errors" >&2
    rm -f "$errors"
    return "$status"
}

# install_packages LIST…: installs the missing packages of the lists; free where none is missing.
install_packages() {
    command -v apt-get >/dev/null ||
        fail "This is not a Debian system. Install the counterparts of the packages in packaging/packages, then use cmake --preset release."
    local missing
    missing=$(missing_packages "$@")
    if [ -n "$missing" ]; then
        may_install "$@"
        say "Installing $(wc -l <<<"$missing") Debian packages: $(one_line <<<"$missing")"
        apt_get update || fail "The lists of packages could not be fetched; the lines above give the reason. Run this again when the network is there."
        # shellcheck disable=SC2086 # one word a package
        apt_get install --no-install-recommends $missing ||
            fail "The packages could not be installed; the lines above give the reason. Run this again: it continues where it stopped."
    fi
    find_cache
}

# Objects that were compiled once are not compiled again, also in another clone; the cache is the user's own.
export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_PCH_EXTSUM=1
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_ctime,include_file_mtime
export NINJA_STATUS='[%f/%t after %e s] '

# writable_folder FOLDER: makes it; false where it cannot be made or written.
writable_folder() { [ -n "$1" ] && mkdir -p "$1" 2>/dev/null && [ -w "$1" ]; }

# find_cache: the compiler's cache lies in the build folder where the user's own cannot be written.
find_cache() {
    writable_folder "$(ccache --get-config cache_dir 2>/dev/null)" || export CCACHE_DIR=$root/build/ccache
    writable_folder "$(ccache --get-config temporary_dir 2>/dev/null)" || export CCACHE_TEMPDIR=$root/build/ccache/tmp
    mkdir -p "${CCACHE_DIR:-$root/build}" "${CCACHE_TEMPDIR:-$root/build}"
}

# configure PRESET [OPTION…]: quick where the build folder is configured and no option changes.
configure() {
    local preset=$1
    shift
    say "Configuring build/$preset"
    (cd "$root" && cmake --preset "$preset" "$@" >"$root/build-$preset.log" 2>&1) || {
        cat "$root/build-$preset.log" >&2
        case "$root" in
        *[!\'[:alnum:][:space:]/._+,@~=-]*)
            fail "The configuration of build/$preset failed. CMake does not build in every folder: move this one to a path of letters, digits and spaces if the lines above give no other reason."
            ;;
        esac
        fail "The configuration of build/$preset failed; the lines above give the reason."
    }
    mv "$root/build-$preset.log" "$root/build/$preset/configure.log"
}

# configure_release: warnings are errors with the compiler that the project is written for, for the program and its tests alike,
# so that neither compiles the other's objects again.
configure_release() {
    local errors=OFF
    [ "$(g++ -dumpversion)" != 12 ] || errors=ON
    configure release -DTOUCHPHOTO_WERROR=$errors
}

# One processor takes so long for a step of a build, on average, where no cache helps.
step_ms=1900

# minutes MILLISECONDS: of processor time, in minutes on the processors of this machine.
minutes() { echo $((($1 / $(cores) + 59999) / 60000)); }

# build PRESET [TARGET…]
build() {
    local preset=$1 steps
    shift
    [ "$#" -gt 0 ] || set -- all
    ninja -C "$root/build/$preset" build.ninja >/dev/null 2>&1 || true # a changed CMakeLists.txt; what fails is shown below
    steps=$(ninja -C "$root/build/$preset" -n "$@" | sed -n '$s|^\[[0-9]*/\([0-9]*\).*|\1|p')
    if [ "${steps:-0}" -gt 20 ]; then
        say "Building build/$preset: $steps steps, up to $(minutes $((steps * step_ms))) minutes on $(cores) processors"
    else
        say "Building build/$preset"
    fi
    cmake --build "$root/build/$preset" --target "$@"
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
