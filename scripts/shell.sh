# Shared by the commands in this folder: sourced, never run.
# Sets `root` (the repository) and `jobs`.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

# quietly WHAT COMMAND...: runs COMMAND with its output held back; shows it only if COMMAND fails.
quietly() {
    local what=$1 log status=0
    shift
    log=$(mktemp)
    "$@" >"$log" 2>&1 </dev/null || status=$?
    if ((status != 0)); then
        cat "$log" >&2
        printf '%s failed (exit code %d)\n' "$what" "$status" >&2
    fi
    rm -f "$log"
    return "$status"
}

# cpp_files: our C++ files, NUL-separated, as git knows them (with those not yet added).
cpp_files() {
    git -C "$root" ls-files -z --cached --others --exclude-standard -- '*.h' '*.cpp'
}
