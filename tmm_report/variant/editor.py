"""The JSON Schema of the format, made from the models, for editors to complete and check a variant with."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from pydantic import create_model
from pydantic.json_schema import GenerateJsonSchema

from tmm_report.variant.model import Block

DIALECT = "https://json-schema.org/draft/2020-12/schema"


class _Schema(GenerateJsonSchema):
    """Without `null`: an empty key is a mistake, what is absent is left out."""

    def nullable_schema(self, schema: Any) -> Any:
        return self.generate_inner(schema["schema"])

    def default_schema(self, schema: Any) -> Any:
        made = super().default_schema(schema)
        return {key: value for key, value in made.items() if key != "default" or value not in (None, {}, [])}

    def dict_schema(self, schema: Any) -> Any:
        made = super().dict_schema(schema)
        return {**made, "additionalProperties": False} if "patternProperties" in made else made

    def model_schema(self, schema: Any) -> Any:
        made = super().model_schema(schema)
        return {**made, "title": schema["cls"].__name__.removesuffix("Model")}


def schema_of(blocks: Iterable[type[Block]], about: str) -> dict[str, Any]:
    """Draft 2020-12, keys as they are written in the file; `about`: what a variant is, in a sentence."""
    model = create_model("VariantModel", __base__=tuple(reversed([*blocks])), __doc__=about)
    return {"$schema": DIALECT, **model.model_json_schema(by_alias=True, schema_generator=_Schema)}
