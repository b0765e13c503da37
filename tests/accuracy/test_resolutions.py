"""The report on larger pixels."""

from PIL import Image

from tmap.accuracy import resolutions
from tmap.compiler.space import SIZES
from tmap.run import conversion


def test_report_shows_what_larger_pixels_save_and_cost(tmp_path, monkeypatch) -> None:
    """Fewer cycles to draw and to convert, more colours that are not the picture's."""
    monkeypatch.setattr(resolutions, "STEP", 60)
    text = resolutions.write(tmp_path, "a1200-fast", names=("floor",))
    rows = [[cell.strip().replace(",", "") for cell in line.split("|")[2:-1]] for line in text.splitlines()[2:]]
    assert [row[0] for row in rows] == [*SIZES]
    drawing, converting, rate, other, error = (dict(zip(SIZES, map(float, column)))
                                               for column in list(zip(*rows))[1:])
    assert drawing["1x1"] > max(drawing["2x1"], drawing["1x2"]) > drawing["2x2"] > drawing["1x1"] / 4
    for size, lines in (("1x1", 256), ("1x2", 128)):  # merged once by the blitter, or twice where a frame takes long
        ways = [320 * lines * conversion.figures()[f"c2p_8_{name}_low", "a1200-mixed", 320] for name in ("blit", "blits")]
        assert min(abs(converting[size] - way) for way in ways) <= 0.51, (size, ways)
    assert converting["1x1"] > converting["1x2"] > converting["2x1"] > converting["2x2"]  # the blitter doubles pixels
    assert rate["2x2"] > 2 * rate["1x1"]
    assert other["1x1"] == error["1x1"] == 0
    assert other["2x2"] > max(other["2x1"], other["1x2"]) > 0 and error["2x2"] > max(error["2x1"], error["1x2"]) > 0
    assert Image.open(tmp_path / "floor_resolutions.png").size == (640, 512) and text in (
        tmp_path / "resolutions.md").read_text()
