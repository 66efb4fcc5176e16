"""Model files of all formats that try to make their reader open another file or a socket."""
import base64
import gzip
import json
import struct

SECRET_POINTS = [(0, 0, 0), (4321.5, 0, 0), (0, 4321.5, 0), (0, 0, 4321.5)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
CUBE = "Cube { width 0.1 height 0.1 depth 0.1 }\n"


def inventor(body):
    return ("#Inventor V2.1 ascii\n" + body + "\n").encode()


def vrml(body):
    return ("#VRML V2.0 utf8\n" + body + "\n").encode()


def secret_inventor():
    points = ", ".join(f"{x} {y} {z}" for x, y, z in SECRET_POINTS)
    faces = ", ".join(f"{a}, {b}, {c}, -1" for a, b, c in FACES)
    return inventor(f"Coordinate3 {{ point [ {points} ] }} IndexedFaceSet {{ coordIndex [ {faces} ] }}")


def secret_buffer(scale=1):
    """48 bytes of points, 12 short indices."""
    points = b"".join(struct.pack("<3f", *(scale * x for x in p)) for p in SECRET_POINTS)
    return points + b"".join(struct.pack("<3H", *f) for f in FACES)


def gltf(uri, image=None, length=72):
    """A glTF whose only buffer is the file `uri`; None: it has none (for .glb)."""
    buffer = {"byteLength": length}
    if uri is not None:
        buffer["uri"] = uri
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [buffer],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                       "min": [0, 0, 0], "max": [4321.5, 4321.5, 4321.5]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}]}
    if image:
        document["images"] = [{"uri": image}]
        document["textures"] = [{"source": 0}]
        document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
        document["meshes"][0]["primitives"][0]["material"] = 0
    return json.dumps(document).encode()


def glb(document, binary=b""):
    document += b" " * (-len(document) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<I4s", len(document), b"JSON") + document
    if binary:
        chunks += struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def binary_inventor(node, field, name):
    """One node with one string field, in Inventor's binary encoding (big-endian, four-byte steps)."""
    def string(text):
        data = text.encode()
        return struct.pack(">I", len(data)) + data + b"\0" * (-len(data) % 4)
    return (b"#Inventor V2.1 binary  \n" + string(node) + struct.pack(">I", 0) + string(field)
            + string(name) + struct.pack(">I", 0) + struct.pack(">I", 0))


def obj(extra):
    return (extra + "\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\n"
            "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n").encode()


def hostile_files(folder):
    """{file name: bytes}. The files that they ask for lie in `folder` and one above it."""
    secret = f"{folder}/secret"
    files = {}
    tricks = {
        "file": 'File {{ name "{0}" }}',
        "so_file": 'SoFile {{ name "{0}" }}',
        "defined_twice": 'DEF DEF File {{ name "{0}" }}',
        "defined_as_use": 'DEF USE File {{ name "{0}" }}',
        "named_file": 'DEF File File {{ name "{0}" }}',
        "unquoted": "SoFile {{ name {0} }}",
        "in_switch": 'Switch {{ whichChild -1 SoFile {{ name "{0}" }} }}',
        "after_quote": 'Info {{ string "a\\"b" }} SoFile {{ name "{0}" }}',
        "in_field": 'Separator {{ Info {{ string "x" }} DEF A SoFile {{ name "{0}" }} USE A }}',
        "after_comment": '# {{\nSoFile {{ name "{0}" }}',
        "inline": 'Inline {{ url "{0}" }}',
        "so_inline": 'SoWWWInline {{ name "{0}" }}',
        "vrml_inline": 'VRMLInline {{ url "{0}" }}',
        "texture": 'Texture2 {{ filename "{0}" }}\n' + CUBE.replace("{", "{{").replace("}", "}}"),
        "texture3": 'SoTexture3 {{ filenames [ "{0}" ] }}\n' + CUBE.replace("{", "{{").replace("}", "}}"),
        "shader": 'ShaderProgram {{ shaderObject [ FragmentShader {{ sourceProgram "{0}" }} ] }}\n'
                  + CUBE.replace("{", "{{").replace("}", "}}"),
        "font": 'Font {{ name "{0}" size 1 }} Text3 {{ string "x" }}',
    }
    for name, text in tricks.items():
        files[f"{name}.iv"] = inventor(text.format("secret.iv"))
        files[f"{name}_absolute.iv"] = inventor(text.format(secret + ".iv"))
    for name, body in {
        "inline": 'Inline { url "secret.iv" }',
        "inline_above": 'Inline { url "../above.iv" }',
        "inline_file": f'Inline {{ url "file://{secret}.iv" }}',
        "inline_web": 'Inline { url "http://127.0.0.1:9/x.wrl" }',
        "proto": 'EXTERNPROTO P [ ] "secret.iv" P { }',
        "proto_list": 'EXTERNPROTO P [ ] [ "secret.iv", "secret.iv#P" ] Group { children P { } }',
        "image": 'Shape { geometry Box { size 0.1 0.1 0.1 } appearance Appearance { texture '
                 'ImageTexture { url "secret.bin" } } }',
        "movie": 'Shape { geometry Box { size 0.1 0.1 0.1 } appearance Appearance { texture '
                 'MovieTexture { url "secret.bin" } } }',
        "sound": 'Sound { source AudioClip { url "secret.bin" } } Shape { geometry Box { } }',
        "script": 'Script { url "javascript:x" } Shape { geometry Box { size 0.1 0.1 0.1 } }',
        "anchor": 'Anchor { url "secret.iv" children Shape { geometry Box { } } }',
        "background": 'Background { frontUrl "secret.bin" } Shape { geometry Box { } }',
    }.items():
        files[f"{name}.wrl"] = vrml(body)
    for node, field in [("File", "name"), ("SoFile", "name"), ("WWWInline", "name"), ("Texture2", "filename")]:
        files[f"binary_{node}.iv"] = binary_inventor(node, field, "secret.iv")
    for name, uri in {
        "passwd": "/etc/passwd", "absolute": secret + ".bin", "above": "../above.bin", "dotted": "./../above.bin",
        "percent": "%2e%2e%2fabove.bin", "file_scheme": f"file://{secret}.bin", "web": "http://127.0.0.1:9/x.bin",
        "other_kind": "secret.iv", "link": "link.bin", "pipe": "pipe.bin", "device": "/dev/zero", "folder": "folder.bin",
        "itself": "itself.gltf", "hidden": ".hidden.bin", "missing": "missing.bin", "empty": "",
        "nul": "secret.iv\0.bin", "newline": "sec\nret.bin",
    }.items():
        files[f"{name}.gltf"] = gltf(uri)
    own = secret_buffer(0.5)  # the file's own numbers, which may arrive
    files["image.gltf"] = gltf("data:application/octet-stream;base64," + base64.b64encode(own).decode(),
                               "secret.bin")
    files["outside.glb"] = glb(gltf("/etc/passwd"))
    files["outside_and_inside.glb"] = glb(gltf("../above.bin"), own)
    for name, extra in {
        "materials": "mtllib secret.mtl\nusemtl a", "materials_absolute": f"mtllib {secret}.mtl",
        "materials_above": "mtllib ../above.mtl", "materials_pipe": "mtllib pipe.bin",
        "call": "call secret.obj", "shell": "csh ls",
    }.items():
        files[f"{name}.obj"] = obj(extra)
    files["texture.ply"] = (b"ply\nformat ascii 1.0\ncomment TextureFile secret.bin\nelement vertex 3\n"
                            b"property float x\nproperty float y\nproperty float z\nelement face 1\n"
                            b"property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    packed = {f"{name}.gz": gzip.compress(files[name], mtime=0)
              for name in ["so_file.iv", "inline.wrl", "passwd.gltf", "above.gltf", "materials.obj"]}
    return files | packed
