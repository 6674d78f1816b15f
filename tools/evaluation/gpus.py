"""The GPUs of phones for which tools/eval.py mali computes bounds, as far as the bounds need them."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Gpu:
    name: str
    number: str  # its name for the compiler
    cores: int
    clock_hz: float
    per_cycle: dict[str, float]  # words of each pipe that a core executes in a cycle at most
    texture: str  # the pipe of texture fetches
    access: str  # the pipe of loads, stores and atomics
    bytes_per_s: float  # of the memory of a phone with this GPU


BIFROST = ("tex", "ldst")
GPUS = {
    # Samsung Exynos 8890, the phone of the thesis: LPDDR4 of 3588 MHz, 64 bits.
    "t880": Gpu("Mali-T880 MP12", "880", 12, 850e6, {"A": 3, "LS": 1, "T": 1}, "T", "LS", 28.7e9),
    # HiSilicon Kirin 970: LPDDR4X of 3733 MHz, 64 bits. A core has three engines of four lanes.
    "g72": Gpu("Mali-G72 MP12", "6221", 12, 746e6, {"arith": 12, "tex": 1, "vary": 8, "ldst": 1}, *BIFROST, 29.8e9),
    # MediaTek Helio G80: LPDDR4X of 3600 MHz, 32 bits. A core has three engines of eight lanes.
    "g52": Gpu("Mali-G52 MC2", "7212", 2, 950e6, {"arith": 24, "tex": 2, "vary": 16, "ldst": 1}, *BIFROST, 14.4e9),
    # MediaTek Dimensity 700: LPDDR4X of 4266 MHz, 32 bits. The rates are those of Mesa's compiler.
    "g57": Gpu("Mali-G57 MC2", "9093", 2, 950e6, {"fma": 64, "cvt": 64, "sfu": 16, "v": 16, "t": 4, "ls": 1}, "t", "ls", 17.1e9),
    # Qualcomm Snapdragon 845: LPDDR4X of 3733 MHz, 64 bits. Two cores of 256 lanes, 24 texels in a cycle.
    "a630": Gpu("Adreno 630", "a630", 2, 710e6, {"alu": 256, "sfu": 64, "tex": 12, "mem": 32}, "tex", "mem", 29.8e9),
}
