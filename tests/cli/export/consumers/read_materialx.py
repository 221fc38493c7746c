# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Validates a MaterialX document and generates shaders of it: python read_materialx.py FILE; JSON."""

import json
import sys

import MaterialX as mx
from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenMdl, PyMaterialXGenOsl
from MaterialX import PyMaterialXGenShader as gen

TARGETS = {
    "osl": PyMaterialXGenOsl.OslShaderGenerator,
    "mdl": PyMaterialXGenMdl.MdlShaderGenerator,
    "glsl": PyMaterialXGenGlsl.GlslShaderGenerator,
}


def sources(document, search_path, element, target):
    generator = TARGETS[target].create()
    colours = gen.DefaultColorManagementSystem.create(generator.getTarget())
    colours.loadLibrary(document)
    generator.setColorManagementSystem(colours)
    context = gen.GenContext(generator)
    context.registerSourceCodeSearchPath(search_path)
    shader = generator.generate(element.getName(), element, context)
    return "\n".join(
        shader.getSourceCode(stage) for stage in ("vertex", "pixel") if shader.hasStage(stage)
    )


def main():
    document = mx.createDocument()
    mx.readFromXmlFile(document, sys.argv[1])
    library = mx.createDocument()
    search_path = mx.getDefaultDataSearchPath()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search_path, library)
    document.setDataLibrary(library)
    valid, message = document.validate()
    materials = {}
    for element in document.getMaterialNodes():
        materials[element.getName()] = {
            target: sources(document, search_path, element, target) for target in TARGETS
        }
    print("JSON" + json.dumps({"valid": valid, "message": message, "materials": materials}))


main()
