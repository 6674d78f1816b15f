"""Reads the parts of an ELF shared library that the checks of an APK need."""

from __future__ import annotations

import dataclasses
import io

from elftools.common.exceptions import ELFError
from elftools.construct import ConstructError
from elftools.elf.elffile import ELFFile

MACHINES = {"arm64-v8a": "EM_AARCH64", "x86_64": "EM_X86_64"}


@dataclasses.dataclass(frozen=True)
class Library:
    machine: str
    sections: frozenset[str]
    segments: tuple[dict, ...]  # headers of those that are loaded
    needed: tuple[str, ...]
    exported: frozenset[str]
    undefined: frozenset[str]  # without weak ones, which may stay so


def read(data: bytes) -> Library:
    """Raises ValueError where it is no ELF file or a damaged one."""
    try:
        file = ELFFile(io.BytesIO(data))
        sections = list(file.iter_sections())
        symbols = [symbol for section in sections if section["sh_type"] == "SHT_DYNSYM" for symbol in section.iter_symbols()
                   if symbol.name and symbol["st_info"]["bind"] != "STB_LOCAL"]
        return Library(
            file["e_machine"],
            frozenset(section.name for section in sections),
            tuple(segment.header for segment in file.iter_segments() if segment["p_type"] == "PT_LOAD"),
            tuple(tag.needed for section in sections if section["sh_type"] == "SHT_DYNAMIC"
                  for tag in section.iter_tags("DT_NEEDED")),
            frozenset(symbol.name for symbol in symbols if symbol["st_shndx"] != "SHN_UNDEF"),
            frozenset(symbol.name for symbol in symbols
                      if symbol["st_shndx"] == "SHN_UNDEF" and symbol["st_info"]["bind"] != "STB_WEAK"))
    except (ELFError, ConstructError, AttributeError, OverflowError, UnicodeDecodeError) as error:
        raise ValueError(f"not an ELF file, or a damaged one ({error})") from error
