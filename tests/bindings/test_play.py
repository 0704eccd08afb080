# SPDX-License-Identifier: BSD-3-Clause
"""`palpate play` without a window, scripts, and published files in press, replay and render."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import time

import jsonschema
import numpy as np
import palpate
import pytest
from matplotlib.image import imread
from palpate import scenario
from palpate.cli.main import main
from palpate.command.verb import WrongCall
from palpate.files.refusal import Refusal
from palpate.runs.play import find_free, open_play
from palpate.runs.run import describe_build, say_missed
from palpate.runs.script_file import read_script_file, write_script_file
from palpate.system.data_folder import find_data_folder, find_record_folder
from published import TASK, TITLE, publish, publish_unstable, read_peak, write_press
from surfaces import organ_scene, press_frames, run_frames


def call(capsys, *words: object) -> tuple[int, str, str]:
    code = main([str(word) for word in words])
    out, err = capsys.readouterr()
    return code, out, err


# ---------------------------------------------------------------- playing


def test_a_script_is_played_headless_and_its_record_replays_bit_by_bit(tmp_path, capsys):
    path, script = publish(tmp_path), write_press(tmp_path)
    record = tmp_path / "run.prec"
    words = ("--device", f"script:{script}", "--headless", "--record", record, "--json")

    code, out, _ = call(capsys, "play", path, *words)

    assert code == 0
    report = json.loads(out)
    assert (report["title"], report["task"]) == (TITLE, TASK)
    assert report["ticks"] + report["missed_ticks"] == 900  # the script and half a second
    assert report["peak_computed_N"] == pytest.approx(read_peak(record), rel=1e-12)
    # of what was computed, what the device was sent: the force fades in over 200 ms
    assert 0.05 < report["peak_force_N"] <= report["peak_computed_N"]
    assert report["outcome"] == "done"
    assert report["motors_off_s"] == 0.0
    assert 0.0 < report["time_in_touch_s"] < 0.5
    header = json.loads(palpate.read_record(record).header)
    assert header["scene"] == "spleen.palpate"
    assert header["scene_sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert header["device"] == "script"
    code, out, _ = call(capsys, "replay", record, "--json")
    assert code == 0
    assert json.loads(out)["equal"]


def test_the_report_for_people_says_where_the_record_is_and_what_this_is_not(
    tmp_path, user_data, capsys
):
    path, script = publish(tmp_path), write_press(tmp_path)

    code, out, _ = call(
        capsys, "play", path, "--device", f"script:{script}", "--headless", "--duration", "300ms"
    )

    assert code == 0
    records = list((user_data / "palpate" / "records").glob("spleen-*.prec"))
    assert len(records) == 1
    assert list(tmp_path.glob("*.prec")) == []
    assert str(records[0]) in out
    assert TITLE in out
    assert "not validated, not a medical device" in out
    assert palpate.read_record(records[0]).complete


def test_of_missed_ticks_it_is_said_whether_the_scene_took_them():
    report = {"missed_ticks": 12, "slow_ticks": 9, "processor_median_us": 950.0}

    assert say_missed({**report, "missed_ticks": 0, "slow_ticks": 0}) == "0 missed"
    assert say_missed({**report, "slow_ticks": 0}) == (
        "12 missed, as the loop was kept waiting: no tick took that long by itself"
    )
    assert say_missed(report) == (
        "12 missed, and 9 took longer by themselves than a tick may; the processor had 0.95 ms for "
        "one in the median"
    )


def test_playing_headless_loads_no_qt(tmp_path):
    path, script = publish(tmp_path), write_press(tmp_path)
    words = [str(path), "--device", f"script:{script}", "--headless", "--duration", "100ms"]
    program = (
        "import sys; from palpate.cli.main import main\n"
        f"code = main(['play', *{words!r}])\n"
        "bad = [m for m in sys.modules if m.startswith(('PySide6', 'shiboken'))]\n"
        "print(bad, file=sys.stderr); sys.exit(code or len(bad))"
    )
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, encoding="utf-8")
    assert ran.returncode == 0, ran.stderr


def test_records_go_to_a_folder_of_the_user_and_replay_from_there(tmp_path, user_data, capsys):
    path, script = publish(tmp_path), write_press(tmp_path)
    assert find_record_folder() == user_data / "palpate" / "records"
    assert open_play(path).record_folder() == find_record_folder()
    assert open_play(path, record=tmp_path / "a.prec").record_folder() == tmp_path

    words = ("--device", f"script:{script}", "--headless", "--duration", "200ms", "--json")
    code, out, _ = call(capsys, "play", path, *words)

    record = json.loads(out)["record"]
    assert code == 0
    assert os.path.dirname(record) == str(find_record_folder())
    assert call(capsys, "replay", record)[0] == 0


def test_the_folder_of_a_users_data_is_that_of_the_system(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_DATA_HOME", "relative/and/so/ignored")
    assert find_data_folder() == tmp_path / ".local" / "share" / "palpate"
    monkeypatch.delenv("XDG_DATA_HOME")
    assert find_data_folder() == tmp_path / ".local" / "share" / "palpate"
    monkeypatch.setattr(sys, "platform", "darwin")
    assert find_data_folder() == tmp_path / "Library" / "Application Support" / "palpate"
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "local"))
    assert find_data_folder() == tmp_path / "local" / "palpate"


def test_records_overwrite_nothing(tmp_path):
    taken = tmp_path / "run.prec"
    assert find_free(taken) == taken
    taken.write_bytes(b"")
    (tmp_path / "run-2.prec").write_bytes(b"")
    assert find_free(taken).name == "run-3.prec"


def test_further_runs_leave_records_of_their_own(tmp_path):
    play = open_play(publish(tmp_path), record=tmp_path / "a.prec")
    for _ in range(3):
        run = play.begin(play.build_device())
        run.finish()

    assert [path.name for path in play.records] == ["a.prec", "a-2.prec", "a-3.prec"]
    assert all(path.exists() for path in play.records)


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        (("--headless",), 2, "--device: got the mouse, expected script:FILE or serial:PORT"),
        (("--device", "glove", "--headless"), 2, "expected pointer, script:FILE, plant"),
        (("--device", "glove"), 2, "expected pointer, script:FILE, plant"),
        (("--device", "script:none.json", "--headless"), 1, "No such file"),
        (("--device", "script:{script}", "--headless", "--duration", "0s"), 2, "more than 0"),
        (
            ("--device", "script:{script}", "--headless", "--record", "{path}"),
            1,
            "a published scenario",
        ),
        (("--device", "script:{script}", "--headless", "--record", "no/a.prec"), 1, "No such file"),
    ],
)
def test_what_cannot_be_played_is_refused_in_a_sentence(tmp_path, capsys, words, code, sentence):
    path, script = publish(tmp_path), write_press(tmp_path)
    given = [word.format(script=script, path=path) for word in words]

    got, out, err = call(capsys, "play", path, *given)

    assert (got, out) == (code, "")
    assert err.startswith("palpate play: ")
    assert sentence in err


def test_a_file_that_is_not_published_is_refused(tmp_path, capsys):
    other, broken = tmp_path / "a.json", tmp_path / "b.palpate"
    other.write_text("{}", encoding="utf-8")
    broken.write_bytes(b"PK\x03\x04 and then nothing")
    for path in (other, broken, tmp_path / "none.palpate"):
        code, _, err = call(capsys, "play", path)
        assert code == 1
        assert err.startswith("palpate play: ")
    with pytest.raises(Refusal, match=r"expected a published file, \.palpate"):
        open_play(other)
    with pytest.raises(WrongCall):
        open_play(publish(tmp_path), "glove")


def test_an_organ_that_blows_up_is_said_and_not_shown_as_a_traceback(tmp_path, capsys):
    path, script = publish_unstable(tmp_path), write_press(tmp_path)

    code, _, err = call(capsys, "play", path, "--device", f"script:{script}", "--headless")

    assert code == 1
    assert "the run was stopped at" in err and "the tissue blew up: " in err


def test_without_a_display_or_pyside_the_window_says_what_is_missing(tmp_path, capsys, monkeypatch):
    path = publish(tmp_path)
    for name in ("QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    code, _, err = call(capsys, "play", path)
    assert code == 1
    assert "there is no display" in err
    monkeypatch.setenv("DISPLAY", ":98765")
    code, _, err = call(capsys, "play", path)
    assert code == 1
    assert "the display :98765 cannot be reached; --headless" in err

    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    monkeypatch.setitem(sys.modules, "palpate.player", None)
    code, _, err = call(capsys, "play", path)
    assert code == 1
    assert 'pip install "palpate[player]"' in err


# ---------------------------------------------------------------- scripts


def test_a_script_comes_back_as_it_was_written_and_fits_its_schema(tmp_path):
    frames = [
        palpate.KeyFrame(0.0, (0.0, 0.1, 0.2)),
        palpate.KeyFrame(1.0 / 3.0, (1e-3, -0.1, 0.2), 1),
    ]
    path = tmp_path / "a.json"
    write_script_file(path, frames)

    back = read_script_file(path)

    assert [(f.time, f.position.tolist(), f.buttons) for f in back] == [
        (f.time, f.position.tolist(), f.buttons) for f in frames
    ]
    folder = os.path.dirname(palpate.__file__)
    with open(f"{folder}/schemas/script.schema.json", encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(json.loads(path.read_text(encoding="utf-8")))


FRAME = '{"time": 0, "position": [0, 0, 0]}'
HEAD = '{"format": "palpate script", "version": 1, "frames": '


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "not JSON"),
        ("[1, 2", "not JSON"),
        ("[" * 100_000, "not JSON"),
        ("[]", "no object"),
        ('{"format": "palpate scene", "version": 1}', "got a scene file, expected a script"),
        ('{"format": "palpate script", "version": 2, "frames": []}', "version: got 2"),
        ('{"format": "palpate script", "version": true, "frames": []}', "version"),
        (HEAD + '[], "more": 1}', "more: got an unknown field"),
        (HEAD + "[]}", "a list of 1 to"),
        (HEAD + "7}", "a list of 1 to"),
        (HEAD + '["a"]}', "an object"),
        (HEAD + '[{"time": 0}]}', "position"),
        (HEAD + '[{"time": -1, "position": [0, 0, 0]}]}', "frames[0].time"),
        (HEAD + '[{"time": 1e9, "position": [0, 0, 0]}]}', "frames[0].time"),
        (HEAD + '[{"time": NaN, "position": [0, 0, 0]}]}', "a finite number"),
        (HEAD + '[{"time": 0, "position": [0, 0]}]}', "2 numbers"),
        (HEAD + '[{"time": 0, "position": [0, 0, Infinity]}]}', "finite numbers"),
        (HEAD + '[{"time": 0, "position": [0, 0, 0], "buttons": 256}]}', "0 to 255"),
        (HEAD + '[{"time": 0, "position": [0, 0, 0], "button": 1}]}', "an unknown field"),
        (HEAD + f"[{FRAME}, {FRAME}]}}", "frames[1].time: got 0 s, expected more than 0 s"),
    ],
)
def test_a_damaged_script_is_refused_with_a_sentence(tmp_path, text, sentence):
    path = tmp_path / "damaged.json"
    path.write_text(text, encoding="utf-8")

    with pytest.raises(Refusal) as refused:
        read_script_file(path)

    assert str(path) in str(refused.value)
    assert sentence in str(refused.value)


def test_a_script_that_nobody_could_follow_is_not_written(tmp_path):
    path = tmp_path / "a.json"
    for frames in ([], [palpate.KeyFrame(0.0), palpate.KeyFrame(0.0)]):
        with pytest.raises(ValueError):
            write_script_file(path, frames)
    assert not path.exists()


# ---------------------------------------------------------------- the other verbs


def test_press_takes_a_published_file_and_writes_the_script_that_play_repeats(tmp_path, capsys):
    path, script = publish(tmp_path), tmp_path / "press.json"
    pressed, played = tmp_path / "press.prec", tmp_path / "play.prec"
    words = ("--depth", "4mm", "--pull", "3mm", "--script", script, "--record", pressed, "--json")

    code, out, _ = call(capsys, "press", path, *words)
    assert code == 0
    assert json.loads(out)["script"] == str(script)
    # what the record says of its scene is the published file
    assert call(capsys, "replay", pressed)[0] == 0

    code, out, _ = call(
        capsys, "play", path, "--device", f"script:{script}", "--headless", "--record", played
    )
    assert code == 0
    first, second = palpate.read_record(pressed).hand, palpate.read_record(played).hand
    same = np.intersect1d(first["time"], second["time"])
    assert len(same) > 500
    for rows in ("position", "buttons"):
        a = first[np.isin(first["time"], same)][rows]
        b = second[np.isin(second["time"], same)][rows]
        assert np.array_equal(a, b)


@pytest.mark.usefixtures("little_sky")
def test_render_draws_a_published_file_and_a_record_made_with_it(tmp_path, capsys):
    path = publish(tmp_path)
    record = tmp_path / "press.prec"
    assert call(capsys, "press", path, "--depth", "4mm", "--record", record)[0] == 0

    for file in (path, record):
        out = tmp_path / f"{file.name}.png"
        code, _, err = call(capsys, "render", file, "-o", out, "--size", "200x150")
        assert code == 0, err
        assert imread(out).shape[:2] == (150, 200)


def test_a_working_file_is_not_pressed_but_sent_to_be_published(tmp_path, capsys):
    path = tmp_path / "spleen.organ"
    path.write_bytes(b"PK")

    code, _, err = call(capsys, "press", path)

    assert code == 1
    assert "got a working file, expected what `palpate publish` makes of it" in err


def test_a_record_is_not_replayed_on_a_published_file_that_has_changed(tmp_path, capsys):
    path = publish(tmp_path)
    record = tmp_path / "press.prec"
    assert call(capsys, "press", path, "--depth", "4mm", "--record", record)[0] == 0
    publish(tmp_path, title="Another title")

    code, _, err = call(capsys, "replay", record)

    assert code == 1
    assert "the scene of press.prec" in err


def test_a_replay_on_another_vector_target_names_the_target_as_the_cause(tmp_path, capsys):
    path, record = publish(tmp_path), tmp_path / "foreign.prec"
    scene = scenario.read(path).scene
    # rounds otherwise than any vector target does
    scene.bodies[0].kernel = palpate.Kernel.reference
    made = run_frames(scene, press_frames())
    header = describe_build(scenario.read(path).scene, path, record, "script")
    made.header = json.dumps(header | {"vector_target": "AVX9"})
    palpate.write_record(record, made)

    code, out, _ = call(capsys, "replay", record)
    asked, told, _ = call(capsys, "replay", record, "--json")

    assert code == asked == 1
    assert "NOT equal" in out and "made with vector target 'AVX9' (here " in out
    assert json.loads(told)["changed"] == {
        "vector_target": {"record": "AVX9", "here": header["vector_target"]}
    }


def test_a_replay_that_differs_under_the_same_program_does_not_blame_the_target(tmp_path, capsys):
    path, record = publish(tmp_path), tmp_path / "changed.prec"
    made = run_frames(scenario.read(path).scene, press_frames())
    made.hand["position"][200, 2] += 1e-6
    made.header = json.dumps(describe_build(scenario.read(path).scene, path, record, "script"))
    palpate.write_record(record, made)

    code, out, _ = call(capsys, "replay", record)

    assert code == 1
    assert "the program or the record has been changed" in out and "made with" not in out


def test_a_pause_in_a_played_run_changes_no_bit_of_its_replay(tmp_path):
    play = open_play(publish(tmp_path), record=tmp_path / "paused.prec", duration=0.4)
    play.frames = press_frames()
    run = play.begin(play.build_device())
    with run:
        time.sleep(0.15)
        run.pause()
        time.sleep(0.1)
        run.resume()
        assert run.wait(60.0)

    record = palpate.read_record(tmp_path / "paused.prec")
    kinds = record.events["kind"].tolist()
    assert kinds.count(palpate.EventKind.paused) == 1
    assert palpate.replay(palpate.scenario.read(play.path).scene, record).equal
    assert palpate.replay(organ_scene(2), record).equal
