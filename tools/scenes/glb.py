"""A small writer of binary glTF 2.0: geometry, textures, materials, nodes, cameras and lights."""
import json
import math
import struct

FLOAT, U8, U16 = 5126, 5121, 5123
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
TRIANGLES, STRIP, FAN = 4, 5, 6


def tidy(value):
    """Rounds to six decimals, because libm's last bit differs between machines and the files must not. -0 becomes 0."""
    return round(value, 6) + 0.0


class Glb:
    def __init__(self, generator):
        self.binary = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": generator, "copyright": "CC0 1.0"},
                     "extensionsUsed": [], "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                     "materials": [], "accessors": [], "bufferViews": [], "buffers": []}

    def _append(self, key, value):
        self.json.setdefault(key, []).append(value)
        return len(self.json[key]) - 1

    def _use(self, extension):
        if extension not in self.json["extensionsUsed"]:
            self.json["extensionsUsed"].append(extension)

    def _view(self, data, target=None):
        self.binary += bytes(-len(self.binary) % 4)  # an accessor starts at a multiple of its component's size
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.binary += data
        return self._append("bufferViews", view)

    def accessor(self, view, component, count, kind, low, high):
        return self._append("accessors", {"bufferView": view, "componentType": component, "count": count, "type": kind,
                                          "min": low, "max": high})

    def _floats(self, rows, kind, target=ARRAY_BUFFER):
        width = len(rows[0])
        data = struct.pack(f"<{len(rows) * width}f", *(tidy(x) for row in rows for x in row))
        stored = struct.unpack(f"<{len(rows) * width}f", data)  # min and max are of the rounded values
        columns = [stored[i::width] for i in range(width)]
        return self.accessor(self._view(data, target), FLOAT, len(rows), kind, [min(c) for c in columns], [max(c) for c in columns])

    def _indices(self, indices):
        wide = max(indices) >= 255  # 255 itself would be the restart index
        data = struct.pack(f"<{len(indices)}{'H' if wide else 'B'}", *indices)
        return self.accessor(self._view(data, ELEMENT_ARRAY_BUFFER), U16 if wide else U8, len(indices), "SCALAR", [min(indices)],
                             [max(indices)])

    def primitive(self, shape, material, mode=TRIANGLES):
        attributes = {"POSITION": self._floats(shape.positions, "VEC3"),
                      "NORMAL": self._floats(shape.normals, "VEC3")}
        if shape.uvs:
            attributes["TEXCOORD_0"] = self._floats(shape.uvs, "VEC2")
        result = {"attributes": attributes, "material": material, "mode": mode}
        if shape.indices:
            result["indices"] = self._indices(shape.indices)
        return result

    def follow_joints(self, primitive, joints, weights):
        """`joints`: four indices into the skin's joints for each vertex; `weights`: theirs, whose sum is 1."""
        data = bytes(index for row in joints for index in row)
        columns = list(zip(*joints))
        primitive["attributes"]["JOINTS_0"] = self.accessor(self._view(data, ARRAY_BUFFER), U8, len(joints), "VEC4",
                                                            [min(c) for c in columns], [max(c) for c in columns])
        primitive["attributes"]["WEIGHTS_0"] = self._floats(weights, "VEC4")

    def skin(self, name, joints, places):
        """`places`: positions of the joints in the space of the mesh, in the pose in which it is modelled."""
        inverse = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -y, -z, 1) for x, y, z in places]
        return self._append("skins", {"name": name, "joints": joints,
                                      "inverseBindMatrices": self._floats(inverse, "MAT4", None)})

    def mesh(self, name, *primitives):
        return self._append("meshes", {"name": name, "primitives": list(primitives)})

    def part(self, name, shape, material, parent=None, **place):
        """Adds a node with a mesh of its own."""
        return self.node(name, parent, mesh=self.mesh(name, self.primitive(shape, material)), **place)

    def texture(self, name, png, wrap, nearest=False):
        image = self._append("images", {"name": name, "mimeType": "image/png", "bufferView": self._view(png)})
        sampler = self._append("samplers", {"magFilter": 9728 if nearest else 9729, "minFilter": 9987,
                                            "wrapS": wrap, "wrapT": wrap})
        return self._append("textures", {"name": name, "source": image, "sampler": sampler})

    def material(self, name, color, texture=None, uv_scale=None, cutoff=None, emissive=None, metallic=0.0,
                 roughness=1.0):
        """`color` is linear. `emissive` is (linear color, strength, texture or None)."""
        surface = {"baseColorFactor": [*color, 1.0], "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
            if uv_scale:
                self._use("KHR_texture_transform")
                surface["baseColorTexture"]["extensions"] = {
                    "KHR_texture_transform": {"scale": [uv_scale, uv_scale], "offset": [0.25, 0.0]}}
        material = {"name": name, "pbrMetallicRoughness": surface}
        if cutoff is not None:
            material.update(alphaMode="MASK", alphaCutoff=cutoff, doubleSided=True)
        if emissive:
            material["emissiveFactor"] = list(emissive[0])
            if emissive[1] != 1:
                self._use("KHR_materials_emissive_strength")
                material["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": emissive[1]}}
            if emissive[2] is not None:
                material["emissiveTexture"] = {"index": emissive[2]}
        return self._append("materials", material)

    def node(self, name, parent=None, **properties):
        """`properties` are glTF's own: mesh, translation, rotation, scale, matrix, camera."""
        index = self._append("nodes", {"name": name, **properties})
        if parent is None:
            self.json["scenes"][0]["nodes"].append(index)
        else:
            self.json["nodes"][parent].setdefault("children", []).append(index)
        return index

    def camera(self, name, eye, target, vertical_fov_deg, near_and_far=(0.1, 100.0)):
        """`near_and_far` in metres; `vct` fits its own to the scene."""
        near, far = near_and_far
        camera = self._append("cameras", {"name": name, "type": "perspective", "perspective": {
            "yfov": tidy(math.radians(vertical_fov_deg)), "znear": near, "zfar": far}})
        forward = [t - e for t, e in zip(target, eye)]
        return self.node(name, translation=list(eye), rotation=look_along(forward), camera=camera)

    def directional_light(self, name, travels, color, lux):
        return self._light(name, None, color, lux, {"type": "directional"}, rotation=look_along(travels))

    def point_light(self, name, place, color, candela, parent=None, **properties):
        """`properties` are glTF's own: range, in metres."""
        return self._light(name, parent, color, candela, {"type": "point", **properties}, translation=list(place))

    def spot_light(self, name, place, travels, color, candela, inner=None, outer=None):
        """Half angles in rad; without them glTF's, 0 and pi / 4."""
        cone = {key: tidy(angle) for key, angle in (("innerConeAngle", inner), ("outerConeAngle", outer)) if angle is not None}
        return self._light(name, None, color, candela, {"type": "spot", "spot": cone}, translation=list(place),
                           rotation=look_along(travels))

    def _light(self, name, parent, color, intensity, kind, **place):
        self._use("KHR_lights_punctual")
        lights = self.json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append({"name": name, **kind, "color": list(color), "intensity": intensity})
        return self.node(name, parent, **place, extensions={"KHR_lights_punctual": {"light": len(lights) - 1}})

    def animate(self, animation, node, path, times, values, interpolation="LINEAR"):
        """Adds a channel to the animation of that name. `values`: one per time, three with CUBICSPLINE."""
        found = [a for a in self.json.get("animations", []) if a["name"] == animation]
        target = found[0] if found else {"name": animation, "channels": [], "samplers": []}
        if not found:
            self._append("animations", target)
        target["samplers"].append({"input": self._floats([(t,) for t in times], "SCALAR", None),
                                   "output": self._floats(values, f"VEC{len(values[0])}", None),
                                   "interpolation": interpolation})
        target["channels"].append({"sampler": len(target["samplers"]) - 1, "target": {"node": node, "path": path}})

    def triangle_count(self):
        def of_mesh(mesh):
            total = 0
            for p in mesh["primitives"]:
                corners = self.json["accessors"][p.get("indices", p["attributes"]["POSITION"])]["count"]
                total += corners // 3 if p["mode"] == TRIANGLES else corners - 2
            return total
        return sum(of_mesh(self.json["meshes"][n["mesh"]]) for n in self.json["nodes"] if "mesh" in n)

    def to_bytes(self):
        binary = bytes(self.binary) + bytes(-len(self.binary) % 4)
        self.json["buffers"] = [{"byteLength": len(binary)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        return (struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(binary))
                + struct.pack("<II", len(text), 0x4E4F534A) + text
                + struct.pack("<II", len(binary), 0x004E4942) + binary)


def look_along(forward):
    """The quaternion (x, y, z, w) that turns -Z to `forward` without roll: yaw about +Y, then pitch."""
    x, y, z = forward
    yaw = math.atan2(-x, -z)
    pitch = math.atan2(y, math.hypot(x, z))
    cy, sy, cp, sp = math.cos(yaw / 2), math.sin(yaw / 2), math.cos(pitch / 2), math.sin(pitch / 2)
    return [tidy_quaternion(q) for q in (cy * sp, sy * cp, -sy * sp, cy * cp)]


def axis_angle(axis, degrees):
    length = math.sqrt(sum(a * a for a in axis))
    half = math.radians(degrees) / 2
    return [tidy_quaternion(math.sin(half) * a / length) for a in axis] + [tidy_quaternion(math.cos(half))]


def product(a, b):
    """Product of quaternions: a rotation by b, then one by a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz]


def tidy_quaternion(value):
    return round(value, 9) + 0.0  # finer than float, so that the quaternion stays of unit length
