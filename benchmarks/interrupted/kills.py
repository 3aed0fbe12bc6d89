"""A batch that is killed again and again, with all its processes, and the same batch undisturbed: the same bytes?

    python -m benchmarks.interrupted.kills    # 50 kills at random moments
    python -m benchmarks.interrupted.kills 200 7        # as many, by another seed

After each kill the batch is taken up again. When it ends by itself a new one begins, until all kills are spent; each
finished tree of files is compared byte by byte with that of a run that nobody disturbed.
"""

from __future__ import annotations

import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[2]
VARIANTS = 40
CHILD = """
import sys
from pathlib import Path
from tmm_report.commands.batch.run import run

class Silent:
    def speak(self, language): pass
    def stage(self, doing): pass
    def tell(self, line): pass
    def warn(self, line): pass

if __name__ == "__main__":
    run([sys.argv[1]], Path(sys.argv[2]), "json", "en", Silent(), jobs=2, resume=True)
"""


def variants(folder: Path) -> None:
    """Crank-rockers with lengths of their own, every tenth of them wrong."""
    text = (ROOT / "variants" / "crank_rocker.yaml").read_text("utf-8")
    for k in range(VARIANTS):
        own = re.sub(r"(?m)^(\s+student:).*$", rf"\1 Student {k}", text)
        if k % 10 == 9:
            own = own.replace("links:", "link:")
        (folder / f"v{k:03}.yaml").write_text(own, encoding="utf-8")


def started(script: Path, source: Path, output: Path) -> subprocess.Popen[bytes]:
    command = [sys.executable, str(script), str(source), str(output)]
    return subprocess.Popen(command, env={**os.environ, "PYTHONPATH": str(ROOT)}, start_new_session=True)


def tree(folder: Path) -> dict[str, bytes]:
    files = (file for file in folder.rglob("*") if file.is_file())
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}


def main() -> None:
    kills, seed = (int(word) for word in (*sys.argv[1:3], *("50", "1")[len(sys.argv[1:3]) :]))
    moments = random.Random(seed)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        source, script = folder / "variants", folder / "batch.py"
        source.mkdir()
        variants(source)
        script.write_text(CHILD)
        began = time.perf_counter()
        assert started(script, source, folder / "undisturbed").wait() == 0
        whole, right = time.perf_counter() - began, tree(folder / "undisturbed")
        done = runs = same = 0
        while done < kills:
            output = folder / "disturbed"
            while True:
                running = started(script, source, output)
                try:
                    running.wait(moments.uniform(0.2, 0.9) * whole if done < kills else None)
                    break
                except subprocess.TimeoutExpired:
                    os.killpg(running.pid, signal.SIGKILL)
                    running.wait()
                    done += 1
            assert running.returncode == 0
            runs += 1
            same += tree(output) == right
            shutil.rmtree(output)
            print(f"{done} kills, {runs} runs", flush=True)
        print(f"{done} kills over {runs} runs of {whole:.1f} s; the same bytes in {same} of {runs}")


if __name__ == "__main__":
    main()
