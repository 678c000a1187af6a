#!/usr/bin/env python3
"""Protects the hardening of release builds (docs/build-on/building.md): what is linked is read-only
once it is loaded, library calls know the sizes of their buffers, what reads files has a stack
protector.

    hardening_test.py LXSRENDER MODULE...
"""
import subprocess
import sys


def said_of(binary, option):
    return subprocess.run(['readelf', '-W', option, binary], check=True, text=True,
                          capture_output=True).stdout


def main():
    faults = []
    for binary in sys.argv[1:]:
        if 'GNU_RELRO' not in said_of(binary, '-l') or 'NOW' not in said_of(binary, '-d'):
            faults.append(f'{binary}: no full RELRO')
    symbols = said_of(sys.argv[1], '--dyn-syms')
    for symbol, what in (('__stack_chk_fail', 'no stack protector'), ('_chk@', 'no FORTIFY')):
        if symbol not in symbols:
            faults.append(f'{sys.argv[1]}: {what}')
    print('\n'.join(faults) or f'{len(sys.argv) - 1} binaries are hardened')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
