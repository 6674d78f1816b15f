"""tools/motion.py: its computations, on surfaces and light whose change is known."""
from __future__ import annotations

import math

import numpy as np
import pytest
from motion import swim
from motion.geometry import MOVES, Seen, View, amount_for, carry, field, relative_change, sampled
from truth.first_hits import TrueGeometry

SIZE = (96, 64)
RIGHT_UP_BACK = np.eye(3)
BACK_WALL = (np.array([0.0, 0, -1]), np.array([0.0, 0, 1]), np.inf)
SLANTED = (np.array([0.0, 0, -1]), np.array([0.28, 0, 0.96]), np.inf)
# A strip of half a unit's width before the wall.
STRIP = (np.array([0.0, 0, -0.6]), np.array([0.0, 0, 1]), 0.1)


def view(eye=(0.0, 0.0, 0.0)) -> View:
    return View(np.array(eye), RIGHT_UP_BACK, math.radians(50), SIZE)


def seen(at: View, *planes) -> Seen:
    """The nearest of planes (a point, the normal, half the width along x), met by arithmetic alone."""
    directions = at.directions()
    depth = np.full(directions.shape[:2], np.inf)
    normals = np.zeros_like(directions)
    for point, normal, half_width in planes:
        t = ((point - at.eye) @ normal) / (directions @ normal)
        x = (at.eye + t[..., None] * directions)[..., 0]
        nearer = (t > 0) & (t < depth) & (np.abs(x) <= half_width)
        depth, normals = np.where(nearer, t, depth), np.where(nearer[..., None], normal, normals)
    valid = np.isfinite(depth)
    return Seen(at, at.eye + np.where(valid, depth, 0)[..., None] * directions, normals, valid)


def change(new: Seen, old: Seen, light_new: np.ndarray, light_old: np.ndarray) -> np.ndarray:
    carried = carry(new, old)
    mean = swim.lengths_mean(light_new, new.valid)
    return relative_change(light_new[carried.mask], sampled(light_old, carried), mean)


def grey(values: np.ndarray) -> np.ndarray:
    return np.repeat(np.broadcast_to(values, (SIZE[1], SIZE[0]))[..., None], 3, -1)


def test_a_point_is_projected_to_the_pixel_that_sees_it():
    at = view((0.2, -0.1, 0.3))
    x, y, depth = at.project(seen(at, SLANTED).position)
    np.testing.assert_allclose(x, np.broadcast_to(np.arange(SIZE[0]) + 0.5, x.shape), atol=1e-9)
    np.testing.assert_allclose(y, np.broadcast_to(np.arange(SIZE[1])[:, None] + 0.5, y.shape), atol=1e-9)
    assert depth.min() > 0


@pytest.mark.parametrize("move", MOVES)
def test_a_frame_moves_by_the_pixels_that_are_asked_for(move: str):
    start = seen(view(), SLANTED)
    moved = MOVES[move](start.view, amount_for(MOVES[move], start, 1.3))
    x, y, _ = moved.project(start.position)
    shift = np.hypot(x - np.arange(SIZE[0]) - 0.5, y - np.arange(SIZE[1])[:, None] - 0.5)
    assert shift.mean() == pytest.approx(1.3, rel=0.05)
    # The picture stays level.
    np.testing.assert_allclose(moved.axes[0][1], 0, atol=1e-12)
    np.testing.assert_allclose(moved.axes @ moved.axes.T, np.eye(3), atol=1e-12)


@pytest.mark.parametrize("move", MOVES)
def test_light_that_stays_on_its_surface_does_not_change(move: str):
    start = seen(view(), SLANTED)
    new = seen(MOVES[move](start.view, amount_for(MOVES[move], start, 1.3)), SLANTED)
    found = change(new, start, field(new), field(start))
    assert len(found) > 0.9 * SIZE[0] * SIZE[1]
    assert np.sqrt(np.mean(found**2)) < 0.003 and found.max() < 0.02
    assert np.ptp(field(start)[..., 0]) > 0.3  # it is no constant


def test_light_that_stays_on_the_screen_changes_by_what_was_computed_by_hand():
    start = seen(view(), BACK_WALL)
    new = seen(MOVES["sideways"](start.view, amount_for(MOVES["sideways"], start, 1.3)), BACK_WALL)
    swing, wave = 0.01, 7.0
    pattern = grey(1 + swing * np.cos(2 * math.pi * np.arange(SIZE[0]) / wave))
    found = change(new, start, pattern, pattern)
    # The surface moves to the left by 1.3 pixels: it was 0.7 of the next pixel's and 0.3 of the one's after that.
    step = np.exp(2j * math.pi / wave)
    expected = swing / math.sqrt(2) * abs(1 - (0.7 * step + 0.3 * step**2)) / 1.1  # the light and a tenth of the mean
    assert np.sqrt(np.mean(found**2)) == pytest.approx(expected, rel=0.03)


@pytest.mark.parametrize("move", MOVES)
def test_what_was_hidden_or_lies_across_an_edge_is_not_compared(move: str):
    """The strip's light is ten times the wall's: a single mixed pixel would be seen."""
    start = seen(view(), BACK_WALL, STRIP)
    new = seen(MOVES[move](start.view, 3 * amount_for(MOVES[move], start, 1.3)), BACK_WALL, STRIP)
    light = [np.where(frame.position[..., 2:] > -0.7, 10.0, 1.0) * np.ones(3) for frame in (new, start)]
    found = change(new, start, *light)
    assert len(found) > 0.75 * SIZE[0] * SIZE[1]
    assert found.max() < 1e-9


def test_two_sides_of_a_corner_are_not_one_surface():
    """The walls of an edge of 160 degrees are less than a quarter of a pixel apart in the pixels beside it."""
    walls = [(np.array([0.0, 0, -1]), np.array([sign * math.sin(math.radians(10)), 0, math.cos(math.radians(10))]), np.inf)
             for sign in (1, -1)]
    start = seen(view(), *walls)
    new = seen(MOVES["sideways"](start.view, amount_for(MOVES["sideways"], start, 1.3)), *walls)
    light = [np.where(frame.normal[..., :1] > 0, 10.0, 1.0) * np.ones(3) for frame in (new, start)]
    assert change(new, start, *light).max() < 1e-9


def test_the_change_is_relative_to_the_light_and_a_tenth_of_the_mean():
    new, old = np.array([[1.0, 1, 1], [0.0, 0, 0], [0.0, 0, 0]]), np.array([[1.1, 1.1, 1.1], [0.0, 0, 0], [5.0, 0, 0]])
    mean = math.sqrt(3)
    assert relative_change(new, old, mean) == pytest.approx([0.1 / (1.05 + 0.1), 0, 5 / (2.5 + 0.1 * mean)])
    assert relative_change(new[1:2], old[1:2], 0.0) == [0.0]  # a black picture


def test_the_true_surfaces_are_those_of_the_file(maker):
    grey = maker.grey()
    maker.quad((-2, 0, 2), (4, 0, 0), (0, 0, -4), grey)
    maker.quad((-2, 0.5, 2), (0, 0, -4), (4, 0, 0), grey)  # looks down: the camera sees through it
    maker.glb.camera("above", (0.3, 1.5, 2.2), (0, -0.1, 0), 42)
    scene = maker.load()
    at = swim.first_view(scene, SIZE)
    position, normal, valid = TrueGeometry(scene)(at.eye, at.directions())
    assert 0.5 < valid.mean() < 1
    floor = -0.25 / scene.side_world  # the origin of trace space is the middle of the scene
    np.testing.assert_allclose(position[valid][:, 1], floor, atol=1e-6)
    np.testing.assert_allclose(normal[valid], np.broadcast_to([0.0, 1, 0], normal[valid].shape), atol=1e-6)
    x, y, _ = at.project(position)
    rows, columns = np.nonzero(valid)
    # Rays that go through a back start again a hair beside where they met it.
    np.testing.assert_allclose(x[valid], columns + 0.5, atol=5e-3)
    np.testing.assert_allclose(y[valid], rows + 0.5, atol=5e-3)
