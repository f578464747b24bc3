"""run_mutants.py TREE RESULTS [--again] [--quick] [--jobs N] [TEXT...]: runs the tests of each mutant, cheapest first, until one
fails; writes a row a mutant to RESULTS and prints the table by room. Mutants with a row are left out; --again takes
those that survived once more, --quick only the first tests of each. TEXT: only mutants whose name, file or fragment holds it."""
import argparse
import concurrent.futures
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import mutants

columns = ["name", "room", "file", "old", "new", "outcome", "by", "seconds"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tree", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("text", nargs="*")
    return parser.parse_intermixed_args()


def program(tree, test):
    return tree / "build/release/tests" / ("test_" + test.split(":")[0].replace("/", "_"))


def run(tree, test, mutant, seconds):
    """Exit code of a test program, 'timeout' past `seconds`. A test is a folder, or folder:FILTER of GoogleTest."""
    command = [program(tree, test), "--gtest_fail_fast", "--gtest_brief=1"]
    if ":" in test:
        command.append("--gtest_filter=" + test.split(":", 1)[1])
    with tempfile.TemporaryDirectory() as scratch:
        env = dict(os.environ, TMPDIR=scratch, TBB_NUM_THREADS="1")
        env.pop("SANDGRAPH_MUTANT", None)
        if mutant:
            env["SANDGRAPH_MUTANT"] = mutant.name
        try:
            done = subprocess.run(command, cwd=scratch, env=env, timeout=seconds, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
            return done.returncode, done.stdout.decode(errors="replace")
        except subprocess.TimeoutExpired:
            return "timeout", ""


def first_failure(output):
    for line in output.splitlines():
        if "FAILED  ]" in line:
            return line.split("]")[1].split()[0].rstrip(",")
    return "crash"


def baseline(tree, tests):
    """Seconds of each test program without a mutant; all must pass."""
    taken = {}
    for test in sorted(tests):
        if not program(tree, test).exists():
            sys.exit(f"error: {program(tree, test)} is not built; leave out --no-build")
        begin = time.monotonic()
        code, output = run(tree, test, None, 1200)
        if code != 0:
            sys.exit(f"error: {test} fails without any mutant: mend that first\n{output[-2000:]}")
        taken[test] = time.monotonic() - begin
    return taken


def judge(tree, mutant, taken):
    begin = time.monotonic()
    row = dict(name=mutant.name, room=mutant.room, file=mutant.file, old=mutant.old, new=mutant.new,
               outcome="survived", by="")
    for test in mutant.tests:
        code, output = run(tree, test, mutant, 30 + 8 * taken[test])
        if code != 0:
            row["outcome"] = "killed"
            row["by"] = f"{test} {'timeout' if code == 'timeout' else first_failure(output)}"
            break
    row["seconds"] = round(time.monotonic() - begin, 1)
    return row


def read_results(path):
    if not path.exists():
        return {}
    with path.open() as stream:
        return {row["name"]: row for row in csv.DictReader(stream)}


def write_results(path, rows):
    with path.open("w") as stream:
        writer = csv.DictWriter(stream, columns)
        writer.writeheader()
        writer.writerows(rows.values())


def table(everything, rows):
    print(f"{'room':<12} {'mutants':>8} {'killed':>7} {'share':>6}   equivalent, not run: "
          f"{sum(bool(m.equivalent) for m in everything)}")
    total = [0, 0]
    for room in sorted({m.room for m in everything}):
        there = [rows[m.name] for m in everything if m.room == room and m.name in rows and not m.equivalent]
        killed = sum(row["outcome"] == "killed" for row in there)
        total = [total[0] + len(there), total[1] + killed]
        if there:
            print(f"{room:<12} {len(there):>8} {killed:>7} {100 * killed / len(there):>4.0f} %")
    if total[0]:
        print(f"{'all':<12} {total[0]:>8} {total[1]:>7} {100 * total[1] / total[0]:>4.0f} %")
    for mutant in everything:
        if mutant.name in rows and rows[mutant.name]["outcome"] == "survived" and not mutant.equivalent:
            print(f"survived: {mutant}")


def main():
    args = arguments()
    everything = mutants.read_all()
    known = {m.name for m in everything}
    rows = {name: row for name, row in read_results(args.results).items() if name in known}
    wanted = [m for m in mutants.named(everything, args.text, args.quick)
              if m.name not in rows or args.again and rows[m.name]["outcome"] == "survived"]
    taken = baseline(args.tree, {test for m in wanted for test in m.tests})
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for done in concurrent.futures.as_completed(pool.submit(judge, args.tree, m, taken) for m in wanted):
            row = done.result()
            rows[row["name"]] = row
            write_results(args.results, rows)
            print(f"{row['outcome']:<8} {row['name']} {row['file']}: {row['old']} -> {row['new']}  ({row['by']})",
                  flush=True)
    table(everything, rows)


if __name__ == "__main__":
    main()
