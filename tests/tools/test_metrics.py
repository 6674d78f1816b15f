"""Metrics on pictures with known answers."""
import flip_evaluator
import numpy as np
import OpenEXR
import pytest

import metrics
from files import Failed
from truth.exr import read_exr, write_exr


def flat(value, size=32):
    return np.full((size, size, 3), value, np.float64)


def test_equal_pictures_have_no_error():
    picture = np.random.default_rng(1).random((32, 32, 3))
    assert max(map(abs, metrics.compare(picture, picture).values())) < 1e-7


def test_a_constant_difference():
    result = metrics.compare(flat(1.1), flat(1.0), flip=False)
    assert result == pytest.approx({"relmse": 0.01 / 1.01, "bias": 0.1, "rmse": 0.1})
    assert metrics.compare(flat(0.8), flat(1.0), flip=False)["bias"] == pytest.approx(-0.2)
    assert metrics.compare(flat(0.5), flat(0.0), flip=False)["bias"] is None


def test_relmse_weighs_each_pixel_by_its_own_reference():
    image, reference = flat(0.0), flat(0.0)
    image[:16], reference[:16] = 2.2, 2.0
    image[16:] = 0.1
    expected = 0.5 * (0.04 / 4.01) + 0.5 * (0.01 / 0.01)
    assert metrics.compare(image, reference, flip=False)["relmse"] == pytest.approx(expected)


def test_flip_is_that_of_srgb_pictures_at_67_pixels_per_degree():
    random = np.random.default_rng(2)
    reference, image = random.random((48, 48, 3)), random.random((48, 48, 3)) * 1.5
    encoded = [np.vectorize(lambda x: 12.92 * x if x <= 0.0031308 else 1.055 * min(x, 1.0) ** (1 / 2.4) - 0.055)(p)
               for p in (reference, image)]
    expected = flip_evaluator.evaluate(*(p.astype(np.float32) for p in encoded), "LDR", parameters={"ppd": 67})[1]
    assert metrics.compare(image, reference)["flip"] == pytest.approx(expected, rel=1e-4)
    assert metrics.compare(flat(1.0), flat(0.0))["flip"] > 0.9


def test_errors_are_means_over_the_pixels_that_count():
    random = np.random.default_rng(4)
    reference, image = random.random((32, 32, 3)), random.random((32, 32, 3))
    pixels = np.zeros((32, 32), bool)
    pixels[:16] = True
    found = metrics.compare(image, reference, pixels=pixels)
    upper = metrics.compare(image[:16], reference[:16], flip=False)
    assert {name: found[name] for name in upper} == pytest.approx(upper)
    image[16:] = reference[16:]
    assert found["flip"] > 1.5 * metrics.compare(image, reference)["flip"], "half of the pixels are equal"


def test_flip_is_that_of_the_pictures_at_their_exposure():
    random = np.random.default_rng(5)
    reference, image = random.random((48, 48, 3)) / 50, random.random((48, 48, 3)) / 50
    pair = [metrics.srgb_from_linear(metrics.neutral(40 * picture)).astype(np.float32) for picture in (reference, image)]
    expected = flip_evaluator.evaluate(*pair, "LDR", parameters={"ppd": 67})[1]
    assert metrics.compare(image, reference, exposure=40.0)["flip"] == pytest.approx(expected, rel=1e-4)
    assert metrics.compare(image, reference)["flip"] < 0.6 * expected


def test_the_automatic_exposure_leaves_black_pixels_out_and_keeps_two_digits():
    assert metrics.automatic_exposure(flat(0.5)) == 0.36 and metrics.automatic_exposure(flat(2049.0)) == 8.8e-5
    half = flat(0.5)
    half[:16] = 1e-6
    assert metrics.automatic_exposure(half) == 0.36 and metrics.automatic_exposure(flat(0.0)) == 1


def test_noise_of_halves_is_the_relmse_of_their_mean():
    random = np.random.default_rng(3)
    a, b = (flat(0.5, 200) + random.normal(0, 0.05, (200, 200, 3)) for _ in range(2))
    assert metrics.noise_of_halves(a, b) == pytest.approx(0.05 ** 2 / 2 / (0.25 + 0.01), rel=0.05)


def test_exr_files_keep_half_floats_and_orientation(tmp_path):
    picture = np.zeros((4, 5, 3), np.float32)
    picture[0, 1], picture[3, 4] = (0.25, 2, 60000), 1 / 3
    write_exr(tmp_path / "a.exr", picture)
    np.testing.assert_array_equal(read_exr(tmp_path / "a.exr"), picture.astype(np.float16))
    header = {"compression": OpenEXR.NO_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, {"Y": np.full((2, 3), 0.5, np.float32)}) as file:
        file.write(str(tmp_path / "y.exr"))
    np.testing.assert_array_equal(read_exr(tmp_path / "y.exr"), np.full((2, 3, 3), 0.5))


def test_unusable_pictures_are_one_clear_error(tmp_path):
    picture = flat(1.0)
    picture[3, 7, 1] = np.nan
    for image, words in ((picture, "x=7, y=3"), (flat(1.0, 8), "8x8")):
        with pytest.raises(Failed, match=words):
            metrics.compare(image, flat(1.0))
    (tmp_path / "broken.exr").write_bytes(b"not a picture")
    for name, words in (("broken.exr", "broken.exr"), ("missing.exr", "no such file")):
        with pytest.raises(Failed, match=words):
            read_exr(tmp_path / name)
