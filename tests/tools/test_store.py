"""The result store: what is measured again, and that nothing finished is lost."""
import json

import pytest

import program
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


def test_stopping_keeps_what_is_finished_and_nothing_half_done(vct, tmp_path):
    runs, folder = Runs(), tmp_path / "out"
    Store(folder).run([runs.task("b")])
    with pytest.raises(KeyboardInterrupt):
        Store(folder).run([runs.task("a"), runs.task("b", 2, error=KeyboardInterrupt())])
    assert set(stored(folder)) == {"render-a"}
    Store(folder).run([runs.task("a"), runs.task("b")])
    assert runs.made == ["b", "a", "b", "b"], "the pictures of the first b were replaced"


@pytest.mark.parametrize("content, words", [("{", "cannot be read"), ('{"version": 0, "results": {}}', "delete the file")])
def test_a_file_that_is_no_store_is_one_clear_error(tmp_path, content, words):
    (tmp_path / "results.json").write_text(content)
    with pytest.raises(Failed, match=words):
        Store(tmp_path)
