"""The animations of references against values that the specification's formulas give by hand."""
import numpy as np
import pytest

from truth.pose import slerp, value_at

TIMES = np.array([1.0, 3.0])


def test_keys_hold_before_the_first_and_after_the_last():
    keys = np.array([[1.0, 2.0, 3.0], [5.0, 6.0, 7.0]])
    for seconds, key in ((0.0, 0), (1.0, 0), (3.0, 1), (9.0, 1)):
        np.testing.assert_array_equal(value_at(TIMES, keys, "LINEAR", False, seconds), keys[key])
    np.testing.assert_allclose(value_at(TIMES, keys, "LINEAR", False, 1.5), [2, 3, 4])
    np.testing.assert_array_equal(value_at(TIMES, keys, "STEP", False, 2.9), keys[0])


def test_a_spline_leaves_and_arrives_with_its_tangents():
    rows = np.array([[9.0], [0.0], [2.0], [-1.0], [1.0], [9.0]])  # in-tangent, value, out-tangent of both keys
    # Half way: the mean of the values, and an eighth of the length times the difference of the tangents between.
    assert value_at(TIMES, rows, "CUBICSPLINE", False, 2.0)[0] == pytest.approx(0.5 + 2 * (2.0 + 1.0) / 8)
    step = 1e-6
    slope = (value_at(TIMES, rows, "CUBICSPLINE", False, 1 + step) - rows[1])[0] / step
    assert slope == pytest.approx(2.0, abs=1e-4)


def test_rotations_take_the_shorter_way():
    quarter = np.array([0, 0, np.sin(np.pi / 4), np.cos(np.pi / 4)])
    still = np.array([0.0, 0, 0, 1])
    for end in (quarter, -quarter):
        half = slerp(still, end, 0.5)
        np.testing.assert_allclose(half, [0, 0, np.sin(np.pi / 8), np.cos(np.pi / 8)], atol=1e-12)
