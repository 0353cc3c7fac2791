"""The schema and model files, by the validator jsonschema where it is there: schema_test.py SCHEMA MODEL..."""
import copy
import json
import sys

try:
    import jsonschema
except ImportError:
    print("SKIPPED: the Python package jsonschema is not here; schema_test.cpp has a validator of its own", file=sys.stderr)
    sys.exit(0)

with open(sys.argv[1]) as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for path in sys.argv[2:]:
    with open(path) as file:
        model = json.load(file)
    validator.validate(model)
    for change in (lambda m: m.pop("experts"), lambda m: m["inputs"][0]["terms"][0]["points"].append(1),
                   lambda m: m["inference"].update(aggregation="sum"), lambda m: m.update(created_utc="yesterday")):
        broken = copy.deepcopy(model)
        change(broken)
        if validator.is_valid(broken):
            sys.exit(f"{path}: a broken model is valid")
print(f"{len(sys.argv) - 2} models")
