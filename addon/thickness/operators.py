# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Let the thickness of the active material vary over its surface."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, StringProperty
from mathutils import Vector

from ..blender.drops import OntoPanels
from ..blender.output import OutputError
from ..films import colours as film_colours
from ..materials.guard import allows_change, reports_errors
from ..materials.image import hold_as_data
from ..materials.subject import active_material, subject
from ..materials.thickness import thickness_range, thickness_socket
from . import heat, painting
from . import nodes as thickness
from .sources import CURVE, POINT, SOURCES, STRENGTH, UPON, source


class _ThicknessOperator(bpy.types.Operator):
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        material = active_material(context)
        if material is None or thickness_socket(material) is None:
            cls.poll_message_set("The active material has no thickness that could vary")
            return False
        return allows_change(cls, material)


class _SourceOperator(_ThicknessOperator):
    """Of one source of the stack: 0 is the uppermost."""

    index: IntProperty(name="Source", description="Which source, from the top", min=0)

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if not thickness.sources_of(active_material(context)):
            cls.poll_message_set("The thickness of the active material does not vary")
            return False
        return True

    def source(self, context) -> bpy.types.ShaderNodeGroup:
        sources = thickness.sources_of(active_material(context))
        if self.index >= len(sources):
            raise OutputError(f"There is no source {self.index}; there are {len(sources)}")
        return sources[self.index]


class NACRE_OT_add_thickness(_ThicknessOperator):
    bl_idname = "nacre.add_thickness"
    bl_label = "Nacre: Vary Thickness"
    bl_description = "Let the film's thickness vary over the surface"
    bl_property = "source"

    source: EnumProperty(
        name="Source",
        description="What the thickness follows",
        items=[(item.id, item.name, item.description, index) for index, item in enumerate(SOURCES)],
    )
    filepath: StringProperty(
        name="Image", description="Picture of the thickness", subtype="FILE_PATH"
    )
    attribute: StringProperty(
        name="Attribute",
        description=f"Name of the attribute; without one, {painting.LAYER!r} is made for painting",
    )

    @classmethod
    def description(cls, _context, properties):
        return next(item.description for item in SOURCES if item.id == properties.source) + "."

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        spec = source(self.source)
        image = None
        if self.source == "map" and self.filepath:
            image = _picture(bpy.path.abspath(self.filepath))  # before anything is changed
        followed = around(context, spec.coordinates)
        below = thickness.sources_of(material)
        added = thickness.add_source(material, self.source, followed)
        if below and not spec.changes_what_is_below:
            names = " · ".join(node.label or node.name for node in below)
            self.report(
                {"INFO"}, _how_it_lies(added, names, bool(thickness.covered([added, *below])))
            )
        if self.source == "map":
            thickness.link_image(material, added, image)
        if self.source.startswith("attribute"):
            name = self.attribute or painting.layer_of(subject(context))
            thickness.link_attribute(material, added, name, ramp=self.source == "attribute")
        return {"FINISHED"}


def _how_it_lies(node: bpy.types.ShaderNodeGroup, names: str, covers: bool) -> str:
    if UPON in node.inputs and node.inputs[UPON].default_value:
        return f"{node.label} heats {names} further."
    if covers:
        return f"{node.label} covers {names}; lower its Strength to see both."
    share = f"{100 * node.inputs[STRENGTH].default_value:.0f} %"
    return f"{node.label} lies upon {names} at {share} of its strength."


def around(context, coordinates: str | None) -> bpy.types.Object | None:
    """What a source follows: made beside the object, unless a curve is selected."""
    if coordinates == POINT:
        return _beside(context, "Film Point", None)
    if coordinates != CURVE:
        return None
    selected = (obj for obj in context.selected_objects or () if obj.type == "CURVE")
    curve = next(selected, None) or _beside(context, "Heat Curve", _line())
    wanted = active_material(context)
    objects = [
        obj
        for obj in context.scene.objects
        if obj.type == "MESH" and any(slot.material == wanted for slot in obj.material_slots)
    ]
    if not objects:
        raise OutputError("Heat along a curve needs a mesh with this material")
    heat.follow_curve(objects, curve)
    return curve


def _beside(context, name: str, data: bpy.types.Curve | None) -> bpy.types.Object:
    """At the upper front left of the active object's box, half as large as that."""
    obj = subject(context)
    corners = [obj.matrix_world @ Vector(corner) for corner in obj.bound_box]
    low, high = (Vector(map(pick, zip(*corners, strict=True))) for pick in (min, max))
    made = bpy.data.objects.new(name, data)
    made[thickness.MADE_HERE] = True
    if data is None:
        made.empty_display_type = "SPHERE"
        made.location = low[0], low[1], high[2]
    else:
        made.location = (low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0, high[2]
    size = max(high - low) / 2.0 or 1.0
    made.scale = size, size, size
    context.collection.objects.link(made)
    return made


def _line() -> bpy.types.Curve:
    curve = bpy.data.curves.new("Heat Curve", "CURVE")
    curve.dimensions = "3D"
    spline = curve.splines.new("BEZIER")
    spline.bezier_points.add(1)
    for point, x in zip(spline.bezier_points, (-1.0, 1.0), strict=True):
        point.co = (x, 0.0, 0.0)
        point.handle_left_type = point.handle_right_type = "AUTO"
    return curve


def _picture(path: str) -> bpy.types.Image:
    before = set(bpy.data.images)
    image = bpy.data.images.load(path, check_existing=True)
    if 0 in image.size:
        if image not in before:
            bpy.data.images.remove(image)
        raise OutputError(f"{path}: is not a picture")
    return image


class NACRE_OT_open_thickness_image(_ThicknessOperator):
    bl_idname = "nacre.open_thickness_image"
    bl_label = "Nacre: Open Thickness Picture"
    bl_description = "Choose a picture whose grey values are the thickness"

    index: IntProperty(name="Source", description="Which source, from the top", min=0)
    filepath: StringProperty(
        name="Image",
        description="Picture of the thickness",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    filter_image: bpy.props.BoolProperty(
        name="Pictures", description="List pictures", default=True, options={"HIDDEN"}
    )
    filter_folder: bpy.props.BoolProperty(
        name="Folders", description="List folders", default=True, options={"HIDDEN"}
    )

    def invoke(self, context, _event):
        if self.properties.is_property_set("filepath"):  # dropped
            return self.execute(context)
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        image = _picture(bpy.path.abspath(self.filepath))  # before anything is changed
        node = _fitting_source(material, self.index, "map")
        if node is None:
            node = thickness.add_source(material, "map")
        thickness.link_image(material, node, image)
        return {"FINISHED"}


def _fitting_source(
    material: bpy.types.Material, index: int, kind: str
) -> bpy.types.ShaderNodeGroup | None:
    """The one that is meant, or the uppermost of its kind."""
    sources = thickness.sources_of(material)
    fitting = [node for node in sources if thickness.spec_of(node).id == kind]
    if index < len(sources) and sources[index] in fitting:
        return sources[index]
    return fitting[0] if fitting else None


class NACRE_OT_read_as_data(_SourceOperator):
    bl_idname = "nacre.read_as_data"
    bl_label = "Nacre: Read as Data"
    bl_description = "Take the grey values of this picture as they are, without a colour space"

    @reports_errors
    def execute(self, context):
        node = _fitting_source(active_material(context), self.index, "map")
        image = thickness.image_node(node).image if node is not None else None
        if image is None:
            raise OutputError("There is no picture yet")
        hold_as_data(image)
        return {"FINISHED"}


class NACRE_OT_remove_thickness_source(_SourceOperator):
    bl_idname = "nacre.remove_thickness_source"
    bl_label = "Nacre: Remove Source of Thickness"
    bl_description = "Take this source away; the others stay"

    @reports_errors
    def execute(self, context):
        thickness.remove_source(active_material(context), self.source(context))
        return {"FINISHED"}


class NACRE_OT_move_thickness_source(_SourceOperator):
    bl_idname = "nacre.move_thickness_source"
    bl_label = "Nacre: Move Source of Thickness"
    bl_description = "Put this source above or below its neighbour"

    direction: EnumProperty(
        name="Direction",
        description="Which way it goes",
        items=(
            ("UP", "Up", "Above the one over it"),
            ("DOWN", "Down", "Below the one under it"),
        ),
    )

    @reports_errors
    def execute(self, context):
        places = 1 if self.direction == "UP" else -1
        if not thickness.move_source(active_material(context), self.source(context), places):
            self.report({"INFO"}, "It cannot go any further.")
            return {"CANCELLED"}
        return {"FINISHED"}


class NACRE_OT_remove_thickness(_ThicknessOperator):
    bl_idname = "nacre.remove_thickness"
    bl_label = "Nacre: One Thickness"
    bl_description = "Take the sources away; the film has one thickness again"

    @reports_errors
    def execute(self, context):
        thickness.remove_sources(active_material(context))
        return {"FINISHED"}


class NACRE_OT_animate_thickness(_ThicknessOperator):
    bl_idname = "nacre.animate_thickness"
    bl_label = "Nacre: Run with the Scene"
    bl_description = "Let the scene's frames run the time of swirls and drainage"

    @reports_errors
    def execute(self, context):
        timed = thickness.timed_sources(active_material(context))
        if not timed:
            self.report({"ERROR"}, "No source of the thickness has a time; add Swirl or Drainage")
            return {"CANCELLED"}
        for node in timed:
            thickness.animate(node)
        return {"FINISHED"}


class NACRE_OT_set_thickness(_ThicknessOperator):
    bl_idname = "nacre.set_thickness"
    bl_label = "Nacre: Set Film Thickness"
    bl_description = "Give the film the thickness that has this colour"

    thickness: FloatProperty(
        name="Thickness", description="In the unit of the material", min=0.0, default=100.0
    )

    @classmethod
    def description(cls, context, properties):
        """Such as `40 nm: purple`."""
        material = active_material(context)
        chips = film_colours.chips(material) if material is not None else ()
        near = min(chips, key=lambda chip: abs(chip.thickness - properties.thickness), default=None)
        if near is None:
            return cls.bl_description
        socket = thickness_socket(material)
        return f"{properties.thickness:.3g}{film_colours.unit(socket)}: {near.name}."

    @reports_errors
    def execute(self, context):
        socket = thickness_socket(active_material(context))
        if socket.is_linked:
            self.report({"ERROR"}, "The thickness varies: change its sources, or take them away")
            return {"CANCELLED"}
        low, high = thickness_range(socket)
        socket.default_value = min(max(self.thickness, low), high)
        return {"FINISHED"}


class NACRE_OT_paint_thickness(_SourceOperator):
    bl_idname = "nacre.paint_thickness"
    bl_label = "Nacre: Start Painting"
    bl_description = "Paint the film's thickness onto the object with Blender's brushes"

    value: FloatProperty(
        name="Value",
        description="What the brush puts on: 0 is the minimum, 1 the maximum; -1: as it was",
        min=-1.0,
        max=1.0,
        default=-1.0,
    )
    colour: StringProperty(name="Colour", description="What the film looks like there")

    @classmethod
    def description(cls, _context, properties):
        return f"Paint with {properties.colour}." if properties.colour else cls.bl_description

    @reports_errors
    def execute(self, context):
        node = _fitting_source(active_material(context), self.index, "attribute")
        attribute = thickness.feed_of(node, "ATTRIBUTE") if node is not None else None
        if attribute is None:
            raise OutputError("This source is not painted; add Paint")
        said = painting.begin(
            context, subject(context), attribute, self.value if self.value >= 0.0 else None
        )
        if said:
            self.report({"INFO"}, said)
        return {"FINISHED"}


class NACRE_OT_stop_painting(bpy.types.Operator):
    bl_idname = "nacre.stop_painting"
    bl_label = "Nacre: Stop Painting"
    bl_description = "Put the brush down; what was painted stays"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if painting.is_on(context.object):
            return True
        cls.poll_message_set("The active object is not being painted")
        return False

    def execute(self, _context):
        bpy.ops.object.mode_set(mode="OBJECT")
        return {"FINISHED"}


class NACRE_MT_thickness(bpy.types.Menu):
    bl_idname = "NACRE_MT_thickness"
    bl_label = "Vary Thickness"

    def draw(self, _context):
        for item in SOURCES:
            if item.group:
                self.layout.label(text=item.group)
            self.layout.operator("nacre.add_thickness", text=item.name).source = item.id
        self.layout.separator()
        self.layout.operator("nacre.remove_thickness", text="One Thickness", icon="X")


class NACRE_FH_thickness_image(OntoPanels, bpy.types.FileHandler):
    bl_idname = "NACRE_FH_thickness_image"
    bl_label = "Nacre: Thickness from Picture"
    bl_import_operator = "nacre.open_thickness_image"
    bl_file_extensions = ".png;.jpg;.jpeg;.tif;.tiff;.exr;.hdr;.webp;.bmp;.tga"


CLASSES = (
    NACRE_OT_add_thickness,
    NACRE_OT_open_thickness_image,
    NACRE_OT_read_as_data,
    NACRE_OT_remove_thickness_source,
    NACRE_OT_move_thickness_source,
    NACRE_OT_remove_thickness,
    NACRE_OT_animate_thickness,
    NACRE_OT_set_thickness,
    NACRE_OT_paint_thickness,
    NACRE_OT_stop_painting,
    NACRE_MT_thickness,
    NACRE_FH_thickness_image,
)
