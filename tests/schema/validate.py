"""Validates what feedscope writes, and the shipped files, against resources/schema: validate.py FEEDSCOPE SOURCE_DIR"""

import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed: skipped")
    sys.exit(77)

feedscope, source = sys.argv[1], pathlib.Path(sys.argv[2])
programs = source / "resources" / "programs"
schemas = {
    file.name.removesuffix(".schema.json"): json.loads(file.read_text())
    for file in sorted((source / "resources" / "schema").glob("*.json"))
}
faults = []


def closed(schema):
    """The schema without room for keys that it does not name: what we write ourselves is described whole."""
    if isinstance(schema, dict):
        schema = {key: closed(value) for key, value in schema.items()}
        if "properties" in schema and "additionalProperties" not in schema and "$ref" not in schema:
            schema["additionalProperties"] = False
    elif isinstance(schema, list):
        schema = [closed(value) for value in schema]
    return schema


def validate(name, data, what, strict=True):
    schema = closed(schemas[name]) if strict else schemas[name]
    for error in jsonschema.Draft202012Validator(schema).iter_errors(data):
        faults.append(f"{what}: {'/'.join(map(str, error.absolute_path))}: {error.message[:200]}")


def written(*arguments):
    result = subprocess.run([feedscope, *map(str, arguments), "--json", "-"], capture_output=True, text=True)
    if result.returncode not in (0, 1):
        faults.append(f"{' '.join(map(str, arguments))}: ended with {result.returncode}: {result.stderr}")
        return None
    return json.loads(result.stdout)


def check_command(*arguments):
    data = written(*arguments)
    if data is not None:
        validate(data["format"]["name"], data, " ".join(map(str, arguments)))
    return data


for name, schema in schemas.items():
    jsonschema.Draft202012Validator.check_schema(schema)

with tempfile.TemporaryDirectory() as folder:
    work = pathlib.Path(folder)
    (work / "wrong.nc").write_text("G21 G1 X1 F100\nfoo\n")
    (work / "empty.nc").write_text("%\n")
    (work / "control.mpf").write_text("G64 G1 X10 F1000\nCYCLE832(0.02,3)\nY10\nG60 G601 X0\nG641 ADIS=0.5\nY0\nM30\n")
    (work / "offset.nc").write_text("G21 G55 G0 X1\nT3 M6\nG41 D5 G1 X10 F500\nY10\nG40 X0\nG28 Z0\n")
    (work / "O100.nc").write_text("O100 G1 X1 F100\nfoo\nM99\n")
    (work / "calls.nc").write_text("O1 G21\nM98 P100\nM30\n")
    own = sorted(work.iterdir())
    samples = [programs / name for name in ("essid_table1.nc", "heidenhain_plate.h", "sinumerik_plate.mpf", "trochoidal_slot.nc")]
    for program in own + samples:
        check_command("check", program)
        check_command("simulate", program, "--contour", work / "contour.csv")
        check_command("explain", program)
        check_command("compare", program, "--model", "essid", "--model", "cam", "--tolerance", "0.01", "--tolerance", "0.05")
    refused = work / "refused.nc"
    refused.write_text("G21 G90\nG1 X10\nG1 Y10\n")
    of_grbl = ("--machine", "grbl-router", "--model", "grbl")
    check_command("simulate", refused, *of_grbl)
    explanation = check_command("explain", refused, *of_grbl)
    if explanation["lost_s"] is not None or explanation["causes"]:
        faults.append("explain: a refused program has times")
    check_command("compare", refused, *of_grbl, "--sweep", "junction_deviation_mm=0.01;0.02", "--within", "0.1")
    check_command("compare", refused, own[0], "--machine", "grbl-router")
    comparison = check_command("compare", refused, *of_grbl)
    (work / "refused.json").write_text(json.dumps(comparison))
    check_command("compare", "--merge", work / "refused.json", "--within", "0.1")
    drives = [part for axis in "XY" for part in ("--set", f"{axis}.kv=60", "--set", f"{axis}.velocity_feedforward=1")]
    check_command("simulate", samples[0], *drives)
    check_command("compare", samples[0], "--model", "essid", *drives)
    load = source / "resources" / "examples" / "trochoidal_slot_load.toml"
    check_command("simulate", programs / "trochoidal_slot.nc", "--load", load)
    check_command("circular", "--radius", "30", "--feed", "6000", "--machine", "mikron-ucp710")
    check_command("circular", "--radius", "5", "--radius", "8", "--feed", "900", "--entry-radius", "2", "--plane", "YZ")
    (work / "circles.nc").write_text("G21 G90 G17 G94 F3000\nG0 X20 Y0\nG3 I-20 J0\nG2 I-20 J0\nG3 I-20 J0 Z-1\nG3 I-20 J0\nM30\n")
    check_command("circular", work / "circles.nc", "--machine", "mikron-ucp710")
    check_command("circular", samples[0])
    studies = []
    for program in samples[:2]:
        data = check_command("compare", program, "--sweep", "tolerance=0.01 0.05", "--within", "0.03", "--operations", "tool")
        studies.append(work / f"{program.stem}.json")
        studies[-1].write_text(json.dumps(data))
    check_command("compare", samples[0], samples[3], "--machine", "spinner-mvc850")
    check_command("compare", samples[0], work / "empty.nc")
    check_command("compare", "--within", "0.03", "--merge", *studies)
    check_command("compare", "--merge", *studies)

    motion = work / "motion.csv"
    corner = work / "corner.ngc"
    corner.write_text("G21 G90 G64 P0.05\nF3000\n(FIRST)\nG1 X30\nY20\n(SECOND)\nX0 Y0\nX30\nM30\n")
    subprocess.run([feedscope, "simulate", corner, "--machine", "linuxcnc-mill", "--set", "X.acceleration=0.5", "--csv", motion,
                    "--step", "0.002"], capture_output=True, check=True)
    check_command("trace", motion)
    alone = check_command("trace", motion, corner, "--machine", "linuxcnc-mill")
    if not (alone["agreement"]["worst"] and alone["agreement"]["corners"] and alone["agreement"]["operations"]):
        faults.append("the trace of the test has no places, corners or operations that could be validated")
    check_command("identify", motion, "--program", corner, "--machine", "linuxcnc-mill", "--model", "linuxcnc", "--model", "grbl",
                  "--fit", "X.acceleration,X.velocity")

    wrong = written("check", samples[0])
    del wrong["program"]["path_mm"]
    wrong["program"]["lines"] = "many"
    before = len(faults)
    validate("feedscope-check", wrong, "a wrong file")
    if len(faults) != before + 2:
        faults.append("a wrong file is not found wrong")
    else:
        del faults[before:]

for file in sorted((source / "machines").glob("*.toml")):
    validate("feedscope-machine", tomllib.loads(file.read_text()), file.name, strict=False)
for file in sorted((source / "resources" / "lessons").glob("*.toml")):
    validate("feedscope-lesson", tomllib.loads(file.read_text()), file.name, strict=False)
for file in sorted((source / "tests").glob("**/*.feedscope")):
    validate("feedscope-session", json.loads(file.read_text()), file.name, strict=file.name == "everything.feedscope")

print("\n".join(faults) if faults else "all files are as their schemas say")
sys.exit(1 if faults else 0)
