// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/cad_shape.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tapeline {

struct CadFaces::Index {
    TopTools_IndexedMapOfShape edges;
};

CadFaces::CadFaces() : index(std::make_unique<Index>()) {}
CadFaces::CadFaces(CadFaces&&) noexcept = default;
CadFaces& CadFaces::operator=(CadFaces&&) noexcept = default;
CadFaces::~CadFaces() = default;

int CadFaces::edge_number(const TopoDS_Edge& edge) const { return index->edges.FindIndex(edge) - 1; }

namespace {

void number_edges(CadFaces& faces)
{
    faces.index->edges.Clear();
    for (const TopoDS_Face& face : faces.faces) {
        TopExp::MapShapes(face, TopAbs_EDGE, faces.index->edges);
    }
    faces.edges.clear();
    for (int e = 1; e <= faces.index->edges.Extent(); ++e) {
        faces.edges.push_back(TopoDS::Edge(faces.index->edges(e)));
    }
}

/// Per edge how often a face runs along it: 1 = free, 2 = shared or a seam.
std::vector<int> count_uses(const CadFaces& faces)
{
    std::vector<int> uses(faces.edges.size(), 0);
    for (const TopoDS_Face& face : faces.faces) {
        for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
            ++uses[faces.edge_number(TopoDS::Edge(edge.Current()))];
        }
    }
    return uses;
}

/// Faces of all connected parts that have a free edge; the closed parts are left out.
std::vector<int> open_parts(const CadFaces& faces)
{
    std::vector<int> parent(faces.faces.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int f) {
        while (parent[f] != f) {
            f = parent[f] = parent[parent[f]];
        }
        return f;
    };
    const std::vector<int> uses = count_uses(faces);
    std::vector<int> first_face(faces.edges.size(), -1);
    std::vector<char> has_free(faces.faces.size(), 0);
    for (size_t f = 0; f < faces.faces.size(); ++f) {
        for (TopExp_Explorer edge(faces.faces[f], TopAbs_EDGE); edge.More(); edge.Next()) {
            const int e = faces.edge_number(TopoDS::Edge(edge.Current()));
            if (first_face[e] < 0) {
                first_face[e] = static_cast<int>(f);
            }
            const int a = root(first_face[e]), b = root(static_cast<int>(f));
            parent[std::max(a, b)] = std::min(a, b);
            has_free[f] |= uses[e] == 1 && !BRep_Tool::Degenerated(TopoDS::Edge(edge.Current()));
        }
    }
    std::vector<char> open(faces.faces.size(), 0);
    for (size_t f = 0; f < open.size(); ++f) {
        open[root(static_cast<int>(f))] |= has_free[f];
    }
    std::vector<int> list;
    for (size_t f = 0; f < open.size(); ++f) {
        if (open[root(static_cast<int>(f))]) {
            list.push_back(static_cast<int>(f));
        }
    }
    return list;
}

/// One pass of sewing; without effect on `faces` when nothing was joined. Returns the number of joined pairs of edges.
int sew(CadFaces& faces, double tolerance_mm, bool may_drop_faces)
{
    const std::vector<int> open = open_parts(faces);
    if (open.empty()) {
        return 0;
    }
    BRepBuilderAPI_Sewing sewing(tolerance_mm);
    for (const int f : open) {
        sewing.Add(faces.faces[f]);
    }
    sewing.Perform();
    const int joined = sewing.NbContigousEdges();
    if (joined == 0) {
        return 0;
    }
    TopTools_IndexedMapOfShape sewn;
    TopExp::MapShapes(sewing.SewedShape(), TopAbs_FACE, sewn);
    std::vector<TopoDS_Face> renewed = faces.faces;
    std::vector<char> dropped(renewed.size(), 0);
    for (const int f : open) {
        const TopoDS_Shape image =
            sewing.IsModified(renewed[f]) ? sewing.Modified(renewed[f]) : TopoDS_Shape(renewed[f]);
        const int found = image.ShapeType() == TopAbs_FACE ? sewn.FindIndex(image) : 0;
        dropped[f] = found == 0;
        if (found > 0) {
            renewed[f] = TopoDS::Face(sewn(found));
        }
    }
    if (!may_drop_faces && std::ranges::count(dropped, 1) > 0) {
        return 0;
    }
    std::vector<int> solid;
    faces.faces.clear();
    for (size_t f = 0; f < renewed.size(); ++f) {
        if (dropped[f]) {
            ++faces.dropped_faces;
        } else {
            faces.faces.push_back(renewed[f]);
            solid.push_back(faces.solid[f]);
        }
    }
    faces.solid = std::move(solid);
    faces.sewn_edges += joined;
    number_edges(faces);
    return joined;
}

/// Sews with a small tolerance first and a wider one only for what stays open, so that gaps are closed and details kept.
void sew_by_size(CadFaces& faces, const TopoDS_Shape& shape)
{
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    const double widest = box.IsVoid() ? 1e-3 : 1e-5 * std::sqrt(box.SquareExtent());
    double tolerance = std::min(1e-3, widest);
    faces.sew_tolerance_mm = tolerance;
    sew(faces, tolerance, true);
    while (tolerance < widest) {
        tolerance = std::min(10 * tolerance, widest);
        if (sew(faces, tolerance, false) > 0) {
            faces.sew_tolerance_mm = tolerance;
        }
    }
}

} // namespace

Result<CadFaces> collect_faces(const TopoDS_Shape& shape, double tolerance_mm)
{
    try {
        CadFaces result;
        TopTools_IndexedMapOfShape faces, solids;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        TopExp::MapShapes(shape, TopAbs_SOLID, solids);
        std::vector<int> solid_of(faces.Extent(), -1);
        for (int s = 1; s <= solids.Extent(); ++s) {
            for (TopExp_Explorer face(solids(s), TopAbs_FACE); face.More(); face.Next()) {
                int& number = solid_of[faces.FindIndex(face.Current()) - 1];
                number = number < 0 ? s - 1 : number;
            }
        }
        for (int f = 1; f <= faces.Extent(); ++f) {
            result.faces.push_back(TopoDS::Face(faces(f)));
        }
        result.solid = std::move(solid_of);
        BRepLib::BuildCurves3d(shape);
        number_edges(result);
        if (tolerance_mm > 0) {
            result.sew_tolerance_mm = tolerance_mm;
            sew(result, tolerance_mm, true);
        } else {
            sew_by_size(result, shape);
        }
        return result;
    } catch (const Standard_Failure& failure) {
        return fail(ErrorKind::rejected, fmt::format("the faces cannot be sewn: OpenCASCADE reports {} {}",
                                                     failure.DynamicType()->Name(), failure.GetMessageString()));
    }
}

} // namespace tapeline
