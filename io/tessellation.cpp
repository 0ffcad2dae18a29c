// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tessellation.h"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <set>

namespace tapeline {

namespace {

TopoDS_Compound compound_of(const CadFaces& faces)
{
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Face& face : faces.faces) {
        builder.Add(compound, face);
    }
    return compound;
}

/// Undoes folds face by face; a part placed twice has its triangles only once.
Unfolded unfold_faces(const CadFaces& faces)
{
    Unfolded all;
    std::set<const Poly_Triangulation*> seen;
    for (const TopoDS_Face& face : faces.faces) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
        if (seen.insert(triangulation.get()).second) {
            const Unfolded own = unfold_face(face);
            all.found += own.found;
            all.left += own.left;
        }
    }
    return all;
}

} // namespace

Result<Unfolded> triangulate_faces(const CadFaces& faces, double linear_deflection_mm, double angular_deflection)
{
    try {
        const TopoDS_Compound compound = compound_of(faces);
        BRepTools::Clean(compound); // triangles that the file brought along have other deflections
        IMeshTools_Parameters parameters;
        parameters.MeshAlgo = IMeshTools_MeshAlgoType_Delabella;
        parameters.Deflection = linear_deflection_mm;
        parameters.Angle = angular_deflection * std::numbers::pi / 180;
        parameters.Relative = false;
        parameters.InParallel = false;
        const BRepMesh_IncrementalMesh triangulated(compound, parameters); // its constructor does the work
        return unfold_faces(faces);
    } catch (const Standard_Failure& failure) {
        return fail(ErrorKind::rejected,
                    fmt::format("the faces cannot be triangulated: OpenCASCADE reports {} {}; heal the model first",
                                failure.DynamicType()->Name(), failure.GetMessageString()));
    }
}

double faces_diagonal(const CadFaces& faces)
{
    Bnd_Box box;
    BRepBndLib::Add(compound_of(faces), box, false);
    return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

std::vector<double> exact_areas(const CadFaces& faces)
{
    std::vector<double> areas;
    for (const TopoDS_Face& face : faces.faces) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties, false, false);
        areas.push_back(std::abs(properties.Mass()));
    }
    return areas;
}

} // namespace tapeline
