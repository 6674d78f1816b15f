"""The result store: what is measured again, and that nothing finished is lost."""
import contextlib
import json
import time

import pytest

import program
from evaluation import progress
from evaluation.store import Store, Task
from files import Failed


@pytest.fixture
def vct(tmp_path, monkeypatch):
    path = tmp_path / "vct"
    path.write_bytes(b"first build")
    monkeypatch.setattr(program, "vct", path)
    return path


class Runs:
    """Tasks that count how often they ran."""

    def __init__(self):
        self.made = []

    def task(self, name, value=1, error=None, **options):
        def measure(folder):
            self.made.append(name)
            (folder / "picture").write_text("drawn")
            if error:
                raise error
            return {"value": value}
        return Task("render", name, {"value": value}, measure, **options)


def stored(folder):
    return json.loads((folder / "results.json").read_text())["results"]


def test_a_second_run_measures_only_what_changed(vct, tmp_path, capsys):
    runs, folder = Runs(), tmp_path / "out"
    assert Store(folder).run([runs.task("a"), runs.task("b")]) == [{"value": 1}, {"value": 1}]
    assert Store(folder).run([runs.task("a"), runs.task("b", 2)]) == [{"value": 1}, {"value": 2}]
    assert runs.made == ["a", "b", "b"]
    assert "[1/2] render: a: unchanged" in capsys.readouterr().err
    assert (folder / "pictures/render-a/picture").is_file()
    Store(folder).run([runs.task("a")], again=True)
    assert runs.made == ["a", "b", "b", "a"]


def test_results_of_another_build_are_removed_except_references(vct, tmp_path):
    runs, folder = Runs(), tmp_path / "out"
    Store(folder).run([runs.task("reference", uses_program=False), runs.task("a"), runs.task("b")])
    vct.write_bytes(b"second build")
    Store(folder).run([runs.task("reference", uses_program=False), runs.task("a")])
    assert runs.made == ["reference", "a", "b", "a"]
    assert set(stored(folder)) == {"render-reference", "render-a"}
    assert not (folder / "pictures/render-b").exists()


def test_a_failure_is_kept_with_its_cause_and_tried_again(vct, tmp_path):
    runs, store = Runs(), Store(tmp_path / "out")
    tasks = [runs.task("bad", error=Failed("no light")), runs.task("good")]
    assert store.run(tasks) == [{"value": 1}] and store.failures(tasks) == ["bad"]
    assert stored(tmp_path / "out")["render-bad"]["failed"] == "no light"
    Store(tmp_path / "out").run(tasks)
    assert runs.made == ["bad", "good", "bad"]


@pytest.mark.parametrize("error", [Failed("no light"), KeyboardInterrupt(), OSError("no space")])
def test_a_result_and_its_pictures_are_kept_until_another_is_complete(vct, tmp_path, error):
    runs, folder = Runs(), tmp_path / "out"
    Store(folder).run([runs.task("b")])
    picture = folder / "pictures/render-b/picture"
    picture.write_text("good")
    with contextlib.suppress(KeyboardInterrupt, OSError):
        Store(folder).run([runs.task("a"), runs.task("b", 2, error=error)])
    assert stored(folder)["render-b"]["result"] == {"value": 1} and picture.read_text() == "good"
    assert {path.name for path in (folder / "pictures").iterdir()} == {"render-a", "render-b"}
    assert Store(folder).run([runs.task("a"), runs.task("b")]) == [{"value": 1}] * 2
    assert runs.made == ["b", "a", "b"], "nothing was lost"
    store = Store(folder)
    assert store.run([runs.task("b", 3)]) == [{"value": 3}] and picture.read_text() == "drawn"
    assert store.failures([runs.task("b")]) == []


def test_a_build_whose_tasks_fail_removes_no_result(vct, tmp_path):
    runs, folder = Runs(), tmp_path / "out"
    Store(folder).run([runs.task("a"), runs.task("b")])
    vct.write_bytes(b"second build")
    tasks, store = [runs.task("a", error=Failed("no light")), runs.task("b")], Store(folder)
    assert store.run(tasks[:1]) == [] and set(stored(folder)) == {"render-a", "render-b"}
    assert store.run(tasks) == [{"value": 1}] and store.failures(tasks) == ["a"]


def test_a_build_that_changes_during_a_run_ends_it(vct, tmp_path):
    def measure(folder):
        vct.write_bytes(b"second build")
        return {}
    with pytest.raises(Failed, match="changed during the run"):
        Store(tmp_path / "out").run([Task("render", "a", {}, measure)])
    assert not (tmp_path / "out/results.json").exists()


def test_a_failure_is_repeated_in_the_last_line_and_ends_the_count_of_seconds(vct, tmp_path, capsys, clock):
    runs, store = Runs(), Store(tmp_path / "out")
    tasks = [runs.task("bad", error=Failed("first line\nno light")), runs.task("good")]
    store.run(tasks)
    clock[0] += 60
    assert progress.current.message() is None
    store.say_failures(tasks)
    assert capsys.readouterr().err.splitlines()[-1] == "error: 1 of 2 failed: bad (no light)"
    store.keep_failures_only(tasks)
    assert "result" not in stored(tmp_path / "out")["render-bad"]


@pytest.fixture
def patient(tmp_path, monkeypatch):
    """A program that does as its argument says, and may be idle for a second."""
    path = tmp_path / "program.sh"
    path.write_text("#!/bin/sh\n"
                    "if [ $1 = work ]; then i=0; while [ $(date +%s) -lt $2 ]; do i=$((i+1)); done; echo done; else exec sleep 60; fi\n")
    path.chmod(0o755)
    monkeypatch.setattr(program, "vct", path)
    monkeypatch.setattr(program, "LONGEST_IDLE_S", 1.0)


def test_a_program_may_take_long_while_it_works(patient):
    assert program.run("work", int(time.time()) + 3).stdout == "done\n"


def test_a_program_that_does_not_work_is_stopped(patient):
    with pytest.raises(Failed, match="not worked for 1 s"):
        program.run("idle")


@pytest.mark.parametrize("content, words", [("{", "cannot be read"), ('{"version": 0, "results": {}}', "delete the file")])
def test_a_file_that_is_no_store_is_one_clear_error(tmp_path, content, words):
    (tmp_path / "results.json").write_text(content)
    with pytest.raises(Failed, match=words):
        Store(tmp_path)


@pytest.fixture
def clock(monkeypatch):
    """The time in seconds, which a test sets."""
    now = [100.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    return now


def test_the_time_left_is_that_of_the_same_preset(vct, tmp_path, capsys, clock):
    def task(name, preset, seconds):
        def measure(folder):
            clock[0] += seconds
            return {}
        return Task("render", name, {}, measure, preset)
    tasks = [task("a", "mobile", 5), task("a2", "quality", 40), task("b", "mobile", 7), task("b2", "quality", 40)]
    Store(tmp_path / "out").run(tasks)
    assert [line.partition(", ")[2] for line in capsys.readouterr().err.splitlines()] == ["", "", "about 45 s left", "about 40 s left"]


def test_work_tells_how_long_it_has_taken_and_then_how_long_the_rest_takes(clock):
    def told(seconds, until):
        found = {}
        while clock[0] < 100 + until:
            clock[0] += seconds
            if message := progress.current.message():
                found[clock[0] - 100] = message
        return found
    progress.begin("tracing")
    assert told(0.5, 10) == {2: "  tracing: 2 s so far", 4: "  tracing: 4 s so far", 8: "  tracing: 8 s so far"}
    countdown = progress.Countdown(400)
    clock[0] += 5
    countdown.advance(50)
    assert progress.current.message() is None and told(0.5, 16) == {16: "  tracing: 12 %, about 34 s left"}
    clock[0] += 4
    countdown.advance(150)  # the first part took 5 s for 50, this one 5 s for 150
    assert told(0.5, 32) == {32: "  tracing: 50 %, about 0 s left"}
