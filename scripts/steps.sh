# What the scripts share: numbered steps, packages, configuring, building. Sourced, not run.
# shellcheck shell=bash

set -euo pipefail

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
packages_file="$root/scripts/packages.txt"
jobs=""
install_packages=yes
groups=(build)
step_number=0
step_count=0

# Space that the packages and the build folders need, with room to spare [MB].
packages_space=1500
build_space=1000

say() { printf '%s\n' "$*"; }

# fail CODE LINE...: an error on stderr, one line an argument, and the end.
fail() {
    local code="$1"
    shift
    printf 'error: %s\n' "$1" >&2
    shift
    if (($#)); then printf '       %s\n' "$@" >&2; fi
    exit "$code"
}

# step TITLE: starts the next numbered step.
step() {
    step_number=$((step_number + 1))
    step_started=$EPOCHREALTIME
    printf '[%d/%d] %s\n' "$step_number" "$step_count" "$*"
}

# step_done WORDS: ends the step with what came out and its wall time.
step_done() {
    local microseconds=$((${EPOCHREALTIME//[.,]/} - ${step_started//[.,]/}))
    printf '      %s (%d.%d s)\n' "$*" $((microseconds / 1000000)) $((microseconds % 1000000 / 100000))
}

# common_option ARG NEXT: reads an option that every script has; sets `used` to how many words it took, 0 if it is not one.
# shellcheck disable=SC2034
common_option() {
    used=0
    case "$1" in
        --jobs | -j)
            [[ "${2:-}" =~ ^[1-9][0-9]*$ ]] || fail 1 "$1 needs a number of at least 1, got '${2:-}'"
            jobs="$2"
            used=2
            ;;
        --jobs=*)
            common_option --jobs "${1#--jobs=}"
            used=1
            ;;
        --no-install)
            install_packages=no
            used=1
            ;;
    esac
}

# choose_jobs: all processors, but no more than one compiler per GB of free memory.
choose_jobs() {
    [[ -z "$jobs" ]] || return 0
    jobs="$(nproc 2>/dev/null || echo 1)"
    local kilobytes
    kilobytes="$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo 2>/dev/null || true)"
    if [[ -n "$kilobytes" ]] && ((kilobytes / 1000000 < jobs)); then jobs=$((kilobytes / 1000000)); fi
    if ((jobs < 1)); then jobs=1; fi
}

# free_space FOLDER: free space there [MB].
free_space() { df -Pk -- "$1" | awk 'NR == 2 { print int($4 / 1024) }'; }

# need_space FOLDER MB WHAT: an error when the disk is too full for WHAT.
need_space() {
    local free
    free="$(free_space "$1")"
    ((free >= $2)) || fail 1 "the disk of $1 is too full for $3: $free MB free, $2 MB needed" "Make room and start again."
}

# system_name: "debian-12", "ubuntu-24.04"; a system that is neither is taken for Debian 12.
system_name() {
    local ID="" VERSION_ID=""
    # shellcheck source=/dev/null
    if [[ -r "${OS_RELEASE:-/etc/os-release}" ]]; then . "${OS_RELEASE:-/etc/os-release}"; fi
    printf '%s-%s' "${ID:-debian}" "${VERSION_ID:-12}"
}

# listed_packages: "name group command reason" of every package, by the name that this system has for it.
listed_packages() {
    awk -v here="$(system_name)" '
        NR == FNR { if ($1 == "@" && $2 == here) other[$3] = $4; next }
        /^[#@]/ || !NF { next }
        $1 in other { if (other[$1] == "-") next; $1 = other[$1] }
        { print }' "$packages_file" "$packages_file"
}

# packages_of GROUP...: names of the packages of these groups.
packages_of() { listed_packages | awk -v groups=" $* " 'index(groups, " " $2 " ") { print $1 }'; }

# why PACKAGE: its reason from the list.
why() { listed_packages | awk -v name="$1" '$1 == name { $1 = $2 = $3 = ""; sub(/^ +/, ""); print }'; }

is_installed() { [[ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]; }

# check_commands GROUP...: where packages cannot be installed, the commands must be there; libraries are left to CMake.
check_commands() {
    local name group command reason absent=()
    while read -r name group command reason; do
        [[ " $* " != *" $group "* || "$command" == - ]] && continue
        command -v "$command" >/dev/null || absent+=("$command: $reason")
    done < <(listed_packages)
    ((${#absent[@]} == 0)) || fail 1 "these commands are missing:" "${absent[@]}" \
        "Install them with the means of this system; scripts/packages.txt has their Debian names."
}

# ensure_packages GROUP...: installs what is missing; nothing is asked of the network when nothing is.
ensure_packages() {
    if [[ "$install_packages" == no ]]; then
        check_commands "$@"
        step_done "left as they are (--no-install)"
        return
    fi
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "      this is neither Debian nor Ubuntu: packages are left as they are, what is there is used"
        check_commands "$@"
        step_done "commands found; libraries are looked for by CMake"
        return
    fi
    local name missing=()
    for name in $(packages_of "$@"); do is_installed "$name" || missing+=("$name"); done
    if ((${#missing[@]} == 0)); then
        step_done "all there"
        return
    fi
    say "      missing: ${missing[*]}"
    install_missing "${missing[@]}"
    step_done "installed: ${missing[*]}"
}

# install_missing PACKAGE...: with apt-get, as root or with sudo.
install_missing() {
    local as_root=(env)
    if ((EUID != 0)); then
        command -v sudo >/dev/null || fail 1 "packages are missing and this is neither root nor is there sudo" \
            "Ask an administrator for: apt-get install --no-install-recommends $*" "or, if they are there by other means, use --no-install."
        if ! sudo -n true 2>/dev/null; then
            [[ -t 0 ]] || fail 1 "packages are missing and sudo asks for a password, which cannot be given here" \
                "Run in a terminal, or first: sudo apt-get install --no-install-recommends $*"
            say "      sudo asks for your password to install them"
            sudo -v || fail 1 "sudo did not let this user install packages" \
                "Ask an administrator for: apt-get install --no-install-recommends $*"
        fi
        as_root=(sudo env)
    fi
    need_space /usr "$packages_space" "the packages"

    local log name unknown=()
    log="$(mktemp)"
    say "      apt-get update"
    if ! "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120 -o Acquire::Retries=2 \
        -o APT::Update::Error-Mode=any update >"$log" 2>&1; then
        say "      warning: apt-get update failed; going on with the lists that are there. It said:"
        apt_errors "$log" | sed 's/^/        /'
    fi
    for name in "$@"; do
        [[ "$(apt-cache policy "$name" 2>/dev/null | awk '/Candidate:/ { print $2 }')" =~ ^[0-9] ]] || unknown+=("$name: $(why "$name")")
    done
    if ((${#unknown[@]})); then
        fail 1 "apt knows no package of this name:" "${unknown[@]}" \
            "Check the network and that /etc/apt/sources.list or /etc/apt/sources.list.d names the whole archive (Debian: main; Ubuntu: universe, too)," \
            "or install them otherwise and use --no-install."
    fi
    say "      apt-get install: some minutes on a fresh machine"
    # apt writes one line a package; they are shown as they come and kept for the message on failure.
    if ! "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=120 -o Acquire::Retries=2 -o Dpkg::Use-Pty=0 \
        install --no-install-recommends "$@" 2>&1 </dev/null | tee "$log" |
        awk '/^(Get:|Setting up|Need to get|After this)/ { print "      " $0; fflush() }'; then
        report_apt_failure "$log" "$@"
    fi
    for name in "$@"; do is_installed "$name" || report_apt_failure "$log" "$name"; done
    rm -f -- "$log"
}

# apt_errors LOG: the first things that apt complains about.
apt_errors() { grep -E '^(E|W):|No space left' "$1" | sort -u | awk 'NR <= 4 { print } END { if (NR > 4) print "... and " NR - 4 " more" }' || true; }

# report_apt_failure LOG PACKAGE...: what could not be had, what apt said, what to do.
report_apt_failure() {
    local log="$1" name absent=() said=() remedy="Check the network and the free space, then start again."
    shift
    for name in "$@"; do is_installed "$name" || absent+=("$name: $(why "$name")"); done
    mapfile -t said < <(apt_errors "$log")
    if grep -q 'No space left\|enough free space' "$log"; then remedy="The disk is full: make room and start again."; fi
    if grep -q 'dpkg was interrupted' "$log"; then remedy="Run 'dpkg --configure -a' as root, then start again."; fi
    fail 1 "packages could not be installed:" "${absent[@]}" "apt-get said:" "${said[@]/#/  }" "$remedy" "Whole output: $log"
}

# configure PRESET: only when something that decides the configuration changed. TYPE21_WERROR=ON in the environment turns
# warnings into errors.
configure() {
    local preset="$1" folder="$root/build/$1" launcher arguments
    launcher="$(command -v ccache || true)"
    arguments=("-DTYPE21_WERROR=${TYPE21_WERROR:-OFF}" "-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher")
    # The clang preset has warnings as errors always.
    if [[ "$preset" == clang ]]; then arguments[0]="-DTYPE21_WERROR=ON"; fi
    local wanted="$root ${arguments[*]}" stamp="$folder/configured"
    if [[ -f "$folder/build.ninja" && -f "$stamp" && "$(<"$stamp")" == "$wanted" && ! "$root/CMakePresets.json" -nt "$stamp" ]]; then
        step_done "nothing to do"
        return
    fi
    need_space "$root" "$build_space" "a build"
    # A cache from another place of the source is refused by CMake: such a folder is begun anew.
    if [[ -f "$folder/CMakeCache.txt" ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
        say "      build/$preset was configured elsewhere and is begun anew"
        rm -rf -- "$folder"
    fi
    mkdir -p -- "$folder"
    local log="$folder/configure.log"
    if ! (cd -- "$root" && cmake --preset "$preset" "${arguments[@]}") >"$log" 2>&1; then
        sed 's/^/      /' "$log" >&2
        local hint=()
        if grep -qi 'could not find' "$log"; then hint=("What it does not find is one of scripts/packages.txt; on Debian they are installed without --no-install."); fi
        fail 1 "CMake could not configure (above; also in $log)" "${hint[@]}"
    fi
    printf '%s' "$wanted" >"$stamp"
    step_done "build/$preset"
}

# build PRESET [TARGET...]: everything, or only the targets, with ninja's own progress.
build() {
    local preset="$1" folder="$root/build/$1"
    shift
    export NINJA_STATUS="      [%f/%t, %es] "
    if ! ninja -C "$folder" -j "$jobs" "$@" | sed -u '/: Entering directory/d; s/^ninja: no work to do\.$/      nothing to do/'; then
        local free
        free="$(free_space "$root")"
        ((free > 50)) || fail 1 "the disk of $root is full ($free MB free): make room and start again"
        fail 1 "the build failed (above)"
    fi
    step_done "build/$preset"
}

# set_up_release COUNT TARGET...: the first three of COUNT steps: packages, configure and build of the release preset, of all
# or only of the targets. The packages are those of `groups`.
set_up_release() {
    step_count="$1"
    shift
    choose_jobs
    step "packages"
    ensure_packages "${groups[@]}"
    step "configure"
    configure release
    step "build, $jobs at a time"
    build release "$@"
}
