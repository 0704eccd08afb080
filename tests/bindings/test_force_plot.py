# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import palpate
import pytest
from matplotlib.image import imread
from palpate.render import draw_force_plot, save_force_plot
from palpate.render.force_plot import plot_records
from palpate.render.trace import find_spans, read_trace

SIZE = (800, 600)
OUTWARD = np.array([0.6, 0.0, 0.8])
STIFFNESS = 200.0


def make_record(stiffness=STIFFNESS, touch=True):
    """Down to 5 mm, a hold, attached, up to 4 mm above, let go: force = stiffness x depth."""
    time = np.arange(0.0, 1.0, 1e-3)
    depth = np.interp(time, [0.0, 0.3, 0.5, 0.8, 1.0], [-2e-3, 5e-3, 5e-3, -4e-3, -4e-3])
    attached = (time >= 0.4) & (time < 0.9)
    touching = ((depth > 0.0) | attached) & touch
    hand = np.zeros(len(time), palpate.HapticSample.dtype)
    hand["time"], hand["orientation"] = time, [0.0, 0.0, 0.0, 1.0]
    felt = np.zeros(len(time), palpate.Felt.dtype)
    felt["force"] = np.where(touching, stiffness * depth, 0.0)[:, None] * OUTWARD
    felt["position"] = [0.1, 0.2, 0.3] - depth[:, None] * OUTWARD
    felt["touched"] = touching + 2 * (attached & touch)
    return palpate.Record(hand=hand, felt=felt), depth


def test_a_trace_finds_the_direction_and_the_depth_of_the_press():
    record, depth = make_record()

    trace = read_trace(record)

    # the first tick of contact is up to one tick, 0.023 mm, below the surface
    assert trace.press == pytest.approx(OUTWARD, abs=1e-4)
    assert np.abs(trace.depth - depth).max() < 3e-5
    assert trace.magnitude().max() == pytest.approx(STIFFNESS * 5e-3, rel=1e-4)


def test_the_force_along_the_press_is_negative_while_it_pulls():
    record, depth = make_record()

    along = read_trace(record).along_press()

    assert along[350] == pytest.approx(1.0, rel=1e-3)
    assert along[850] == pytest.approx(-0.8, rel=1e-3)
    assert along[950] == 0.0


def test_a_record_that_touched_nothing_has_no_depth():
    trace = read_trace(make_record(touch=False)[0])

    assert np.isnan(trace.depth).all()
    assert not trace.along_press().any()


def test_a_force_that_the_motors_did_not_give_was_not_felt():
    record, _ = make_record()
    whole, felt = read_trace(record), record.felt.copy()
    cut = record.hand["time"] > 0.2
    felt["touched"][cut] |= palpate.NOT_RENDERED

    trace = read_trace(palpate.Record(hand=record.hand, felt=felt))

    assert whole.force[cut].any()
    assert not trace.force[cut].any()
    assert np.array_equal(trace.force[~cut], whole.force[~cut])
    assert np.array_equal(trace.touching, whole.touching)


def test_spans_begin_and_end_with_their_ticks():
    time = 0.001 * np.arange(10)
    on = np.array([1, 1, 0, 0, 1, 0, 0, 1, 1, 1], bool)

    spans = find_spans(time, on)

    assert np.allclose(spans, [(0.0, 0.002), (0.004, 0.001), (0.007, 0.002)])
    assert find_spans(time, np.zeros(10, bool)) == []


def test_the_panels_show_the_numbers_of_the_record():
    record, depth = make_record()

    figure = plot_records({"mass-spring": record}, "ball", "dark", SIZE).figure
    force, parts, tool, contact, loop = figure.axes

    assert np.allclose(
        force.lines[0].get_ydata(),
        STIFFNESS
        * np.abs(depth)
        * ((depth > 0) | (np.arange(1000) >= 400) & (np.arange(1000) < 900)),
        atol=1e-6,
    )
    assert force.get_ylabel() == "force [N]"
    assert "1 N" in force.get_legend().get_texts()[0].get_text()
    assert np.allclose([line.get_ydata() for line in parts.lines], record.felt["force"].T)
    assert np.allclose(tool.lines[0].get_ydata(), 1e3 * depth, atol=0.03)
    assert "[mm]" in tool.get_ylabel() and "[mm]" in loop.get_xlabel()
    assert contact.get_yticklabels()[0].get_text() == "mass-spring"
    touching, attached = (bars.get_paths() for bars in contact.collections)
    assert [path.get_extents().x0 for path in attached] == pytest.approx([0.4])
    assert [path.get_extents().x1 for path in attached] == pytest.approx([0.9])
    assert [path.get_extents().x0 for path in touching] == pytest.approx([0.086])
    assert figure.get_suptitle() == "ball"


@pytest.mark.parametrize("size", [(800, 600), (1280, 800), (2560, 1600)])
def test_labels_of_the_panels_do_not_overlap(size):
    record, _ = make_record()
    runs = {"mass-spring": record, "molecular": make_record(stiffness=150.0)[0]}

    canvas = plot_records(runs, "ball", "light", size)
    canvas.draw()
    boxes = [axes.get_tightbbox(canvas.get_renderer()) for axes in canvas.figure.axes]

    assert not any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])
    assert all(b.x0 >= 0 and b.y0 >= 0 and b.x1 <= size[0] and b.y1 <= size[1] for b in boxes)


def test_every_run_is_drawn_in_a_colour_of_its_own():
    soft, stiff = make_record(stiffness=100.0)[0], make_record(stiffness=300.0)[0]

    one = draw_force_plot({"soft": soft}, size=SIZE)
    two = draw_force_plot({"soft": soft, "stiff": stiff}, size=SIZE)

    blue = [(p[..., 2].astype(int) - p[..., 0] > 80).sum() for p in (one, two)]
    assert blue[0] == 0
    assert blue[1] > 500


def test_the_same_plot_is_the_same_file(tmp_path):
    record, _ = make_record()

    for name in ("one.png", "two.png"):
        save_force_plot(tmp_path / name, {"mass-spring": record}, title="ball", size=SIZE)

    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()
    assert imread(tmp_path / "one.png").shape[:2] == (600, 800)


@pytest.mark.filterwarnings("error")
def test_a_run_that_touched_nothing_is_plotted_and_says_so():
    record, _ = make_record(touch=False)

    figure = plot_records({"air": record}, "", "dark", SIZE).figure

    said = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert said == ["nothing was touched"] * 2


@pytest.mark.parametrize(
    ("records", "options", "word"),
    [
        ({}, {}, "records: got none, expected at least one"),
        ({"none": palpate.Record()}, {}, "record: got no ticks"),
        ({"run": make_record()[0]}, {"theme": "pink"}, "theme"),
        ({"run": make_record()[0]}, {"size": (100, 100)}, "size"),
    ],
)
def test_a_plot_of_nothing_is_refused(records, options, word):
    with pytest.raises(ValueError, match=word):
        draw_force_plot(records, **options)
