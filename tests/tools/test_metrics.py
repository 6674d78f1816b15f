"""Metrics on pictures with known answers."""
import flip_evaluator
import numpy as np
import OpenEXR
import pytest

import metrics
from truth.exr import PictureError, read_exr, write_exr


def flat(value, size=32):
    return np.full((size, size, 3), value, np.float64)


def test_equal_pictures_have_no_error():
    picture = np.random.default_rng(1).random((32, 32, 3))
    result = metrics.compare(picture, picture)
    for key in ("relmse", "bias", "rmse", "p999", "flip", "hdr_flip"):
        assert result[key] == pytest.approx(0, abs=1e-7), key


def test_a_constant_difference():
    result = metrics.compare(flat(1.1), flat(1.0), flip=False)
    assert result["relmse"] == pytest.approx(0.01 / 1.01)
    assert result["bias"] == pytest.approx(0.1)
    assert result["rmse"] == pytest.approx(0.1)
    assert result["p999"] == pytest.approx(0.1)
    assert metrics.compare(flat(0.8), flat(1.0), flip=False)["bias"] == pytest.approx(-0.2)


def test_relmse_weighs_each_pixel_by_its_own_reference():
    image, reference = flat(0.0), flat(0.0)
    image[:16], reference[:16] = 2.2, 2.0
    image[16:] = 0.1
    expected = 0.5 * (0.04 / 4.01) + 0.5 * (0.01 / 0.01)
    assert metrics.compare(image, reference, flip=False)["relmse"] == pytest.approx(expected)


def test_the_percentile_sees_two_pixels_in_a_thousand_and_not_half_of_one():
    reference, image = flat(0.0, 100), flat(0.0, 100)
    image.reshape(-1, 3)[:20] = 5
    assert metrics.compare(image, reference, flip=False)["p999"] == 5
    image.reshape(-1, 3)[5:] = 0
    assert metrics.compare(image, reference, flip=False)["p999"] == 0


def test_sparks_outshine_all_that_is_near_them():
    reference = flat(0.5)
    reference[:, 20:] = 4.0
    image = reference.copy()
    image[5, 5], image[9, 9] = 1.01, 0.99  # more and less than twice 0.5
    image[12, 18] = 4.0  # two pixels from what is as bright
    image[12, 17] = 4.0  # three pixels
    found = metrics.sparks(image, reference)
    assert np.argwhere(found).tolist() == [[5, 5], [12, 17]]
    assert metrics.compare(image, reference, flip=False)["sparks"] == 2
    assert not metrics.sparks(flat(0.019), flat(0.0)).any() and metrics.sparks(flat(0.021), flat(0.0)).all()


def test_a_black_reference_has_no_bias():
    assert metrics.compare(flat(0.5), flat(0.0), flip=False)["bias"] is None


def test_only_pixels_of_the_mask_count():
    image, mask = flat(1.0), np.zeros((32, 32), bool)
    image[:, 16:] = 3
    mask[:, :16] = True
    result = metrics.compare(image, flat(1.0), mask=mask)
    assert result["relmse"] == 0 and result["p999"] == 0
    assert metrics.compare(image, flat(1.0), mask=~mask, flip=False)["rmse"] == pytest.approx(2)
    with pytest.raises(PictureError, match="no pixel"):
        metrics.compare(image, flat(1.0), mask=np.zeros((32, 32), bool))


def test_flip_is_that_of_srgb_pictures_at_67_pixels_per_degree():
    random = np.random.default_rng(2)
    reference, image = random.random((48, 48, 3)), random.random((48, 48, 3)) * 1.5
    encoded = [np.vectorize(lambda x: 12.92 * x if x <= 0.0031308 else 1.055 * min(x, 1.0) ** (1 / 2.4) - 0.055)(p)
               for p in (reference, image)]
    expected = flip_evaluator.evaluate(*(p.astype(np.float32) for p in encoded), "LDR", parameters={"ppd": 67})[1]
    assert metrics.compare(image, reference)["flip"] == pytest.approx(expected, rel=1e-4)
    assert metrics.compare(flat(1.0), flat(0.0))["flip"] > 0.9


def test_hdr_flip_uses_the_exposures_it_is_given():
    """The same ratio of two dim pictures is unseen in dark exposures and seen in bright ones."""
    reference, image = flat(0.01), flat(0.02)
    dark = metrics.compare(image, reference, {"start": -6.0, "stop": -5.0, "count": 2})
    bright = metrics.compare(image, reference, {"start": 4.0, "stop": 5.0, "count": 2})
    assert dark["hdr_flip"] < 0.05 < 0.1 < bright["hdr_flip"]
    assert dark["flip"] == bright["flip"]


def test_automatic_exposures_bring_the_brightest_and_the_median_to_85_percent():
    picture = flat(0.0)
    picture[:20] = 0.25
    picture[0, 0] = 4
    chosen = metrics.automatic_exposures(picture)

    def aces(x):  # HDR-FLIP's: Narkowicz's fit after a factor of 0.6
        x = 0.6 * x
        return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)

    assert aces(4 * 2 ** chosen["start"]) == pytest.approx(0.85, abs=0.03)
    assert aces(0.25 * 2 ** chosen["stop"]) == pytest.approx(0.85, abs=0.03)
    assert chosen["count"] == 4
    assert metrics.automatic_exposures(flat(0.0))["count"] == 2


def test_noise_of_halves_is_the_relmse_of_their_mean():
    random = np.random.default_rng(3)
    a, b = (flat(0.5, 200) + random.normal(0, 0.05, (200, 200, 3)) for _ in range(2))
    assert metrics.noise_of_halves(a, b) == pytest.approx(0.05 ** 2 / 2 / (0.25 + 0.01), rel=0.05)


def test_an_error_below_the_noise_is_flagged():
    reference = flat(1.0)
    near, far = flat(1.01), flat(1.05)  # relMSE 1e-4 and 2.5e-3
    assert metrics.compare(near, reference, noise_relmse=1e-4, flip=False)["at_noise_floor"]
    assert not metrics.compare(far, reference, noise_relmse=1e-4, flip=False)["at_noise_floor"]
    assert "at_noise_floor" not in metrics.compare(far, reference, flip=False)


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
        with pytest.raises(PictureError, match=words):
            metrics.compare(image, flat(1.0))
    (tmp_path / "broken.exr").write_bytes(b"not a picture")
    for name, words in (("broken.exr", "broken.exr"), ("missing.exr", "no such file")):
        with pytest.raises(PictureError, match=words):
            read_exr(tmp_path / name)
