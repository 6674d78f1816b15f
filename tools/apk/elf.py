"""Reads the headers of an ELF shared library of a 64-bit phone (ELF-64 object file format, version 1.5)."""

from __future__ import annotations

import dataclasses
import struct

PT_LOAD = 1
SHT_DYNAMIC, SHT_DYNSYM = 6, 11
DT_NULL, DT_NEEDED = 0, 1
SHN_UNDEF = 0
STB_LOCAL, STB_WEAK = 0, 2
MACHINES = {"arm64-v8a": 183, "x86_64": 62}


@dataclasses.dataclass(frozen=True)
class Segment:
    offset: int  # bytes into the file
    address: int
    alignment: int


@dataclasses.dataclass(frozen=True)
class Library:
    machine: int
    sections: frozenset[str]
    segments: tuple[Segment, ...]  # those that are loaded
    needed: tuple[str, ...]
    exported: frozenset[str]
    undefined: frozenset[str]  # without weak ones, which may stay so


def _text(table: bytes, offset: int) -> str:
    return table[offset : table.index(b"\0", offset)].decode()


def read(data: bytes) -> Library:
    """Raises ValueError where it is no 64-bit little-endian ELF file."""
    if data[:6] != b"\x7fELF\x02\x01":
        raise ValueError("not a 64-bit little-endian ELF file")
    try:
        return _read(data)
    except (struct.error, IndexError) as error:
        raise ValueError(f"a damaged ELF file ({error})") from error


def _read(data: bytes) -> Library:
    machine = struct.unpack_from("<H", data, 18)[0]
    programs, headers = struct.unpack_from("<QQ", data, 32)
    program_size, program_count, header_size, header_count, names_index = struct.unpack_from("<HHHHH", data, 54)

    segments = []
    for i in range(program_count):
        kind, _, offset, address, _, _, _, alignment = struct.unpack_from("<IIQQQQQQ", data, programs + i * program_size)
        if kind == PT_LOAD:
            segments.append(Segment(offset, address, alignment))

    sections = [struct.unpack_from("<IIQQQQIIQQ", data, headers + i * header_size) for i in range(header_count)]

    def content(index: int) -> bytes:
        return data[sections[index][4] : sections[index][4] + sections[index][5]]

    names = content(names_index)
    needed, exported, undefined = [], set(), set()
    for index, (_, kind, _, _, _, _, link, _, _, _) in enumerate(sections):
        if kind == SHT_DYNAMIC:
            for tag, value in struct.iter_unpack("<qQ", content(index)):
                if tag == DT_NULL:
                    break
                if tag == DT_NEEDED:
                    needed.append(_text(content(link), value))
        elif kind == SHT_DYNSYM:
            strings = content(link)
            for name, info, _, section, _, _ in struct.iter_unpack("<IBBHQQ", content(index)):
                binding = info >> 4
                if binding == STB_LOCAL or name == 0:
                    continue
                if section != SHN_UNDEF:
                    exported.add(_text(strings, name))
                elif binding != STB_WEAK:
                    undefined.add(_text(strings, name))
    section_names = frozenset(_text(names, section[0]) for section in sections)
    return Library(machine, section_names, tuple(segments), tuple(needed), frozenset(exported), frozenset(undefined))
