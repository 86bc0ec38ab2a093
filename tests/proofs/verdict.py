"""How every proof ends: one line when the law holds, one line a violation when it does not."""
import subprocess
import sys


def verdict(law, violations, evidence):
    """Prints the outcome and returns the exit code: 0 when there is no violation, 1 otherwise.

    `evidence` says what was looked at, so that a proof about nothing is seen to be one.
    """
    if not violations:
        print(f"holds: {law} ({evidence})")
        return 0
    for violation in violations:
        print(violation, file=sys.stderr)
    print(f"broken: {law}: {len(violations)} violation(s) ({evidence})", file=sys.stderr)
    return 1


def output_of(*command):
    """Standard output of a program that must succeed; its own message is passed on when it does not."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        raise SystemExit(f"{command[0]} failed with exit code {done.returncode}: {done.stderr.strip()}")
    return done.stdout
