// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/face_weld.h"

#include "io/face_unfold.h"

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace tapeline {

namespace {

/// Sets of nodes that are one vertex; the smallest node stands for its set.
class NodeSets {
public:
    explicit NodeSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    int find(int node)
    {
        while (parent_[node] != node) {
            node = parent_[node] = parent_[parent_[node]];
        }
        return node;
    }
    void join(int a, int b)
    {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<int> parent_;
};

/// Collects which nodes of which face lie where on the CAD edges and vertices, and joins them.
class Welder {
public:
    explicit Welder(const CadFaces& faces) : faces_(faces), start_(faces.faces.size() + 1, 0)
    {
        for (size_t f = 0; f < faces.faces.size(); ++f) {
            TopLoc_Location location;
            const auto& triangulation = BRep_Tool::Triangulation(faces.faces[f], location);
            start_[f + 1] = start_[f] + (triangulation.IsNull() ? 0 : triangulation->NbNodes());
        }
        edge_nodes_.resize(faces.edges.size());
    }

    WeldedFaces weld()
    {
        NodeSets sets(start_.back());
        WeldedFaces result;
        std::vector<char> unmatched(faces_.edges.size(), 0);
        for (size_t f = 0; f < faces_.faces.size(); ++f) {
            join_border(static_cast<int>(f), sets, unmatched);
        }
        result.unmatched_edges = static_cast<int>(std::ranges::count(unmatched, 1));
        fill(result, sets);
        return result;
    }

private:
    /// Walks the edges of a face (explored forward, so that a seam comes once in each sense with its own nodes).
    void join_border(int f, NodeSets& sets, std::vector<char>& unmatched)
    {
        TopLoc_Location location;
        const TopoDS_Face face = TopoDS::Face(faces_.faces[f].Oriented(TopAbs_FORWARD));
        const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
        if (triangulation.IsNull()) {
            return;
        }
        for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
            const Handle(Poly_PolygonOnTriangulation) polygon =
                BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
            if (polygon.IsNull()) {
                continue;
            }
            std::vector<int> nodes(polygon->NbNodes());
            for (size_t i = 0; i < nodes.size(); ++i) {
                nodes[i] = start_[f] + polygon->Node(static_cast<int>(i) + 1) - 1;
            }
            const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
            join_vertex(TopExp::FirstVertex(forward), nodes.front(), sets);
            join_vertex(TopExp::LastVertex(forward), nodes.back(), sets);
            const int e = faces_.edge_number(edge);
            if (BRep_Tool::Degenerated(edge)) {
                std::ranges::for_each(nodes, [&](int node) { sets.join(nodes.front(), node); });
                continue;
            }
            if (edge_nodes_[e].empty()) {
                edge_nodes_[e].push_back(nodes);
            } else if (edge_nodes_[e].front().size() == nodes.size()) {
                for (size_t i = 0; i < nodes.size(); ++i) {
                    sets.join(edge_nodes_[e].front()[i], nodes[i]);
                }
            } else {
                unmatched[e] = 1;
                edge_nodes_[e].push_back(nodes);
            }
        }
    }

    void join_vertex(const TopoDS_Vertex& vertex, int node, NodeSets& sets)
    {
        if (vertex.IsNull()) {
            return;
        }
        const int number = vertices_.Add(vertex) - 1;
        if (number == static_cast<int>(vertex_node_.size())) {
            vertex_node_.push_back(node);
        } else {
            sets.join(vertex_node_[number], node);
        }
    }

    /// Per node that stands for a set: whether a triangle has one of the set's nodes.
    std::vector<char> used_sets(NodeSets& sets) const
    {
        std::vector<char> used(start_.back(), 0);
        TopLoc_Location location;
        for (size_t f = 0; f < faces_.faces.size(); ++f) {
            const auto& triangulation = BRep_Tool::Triangulation(faces_.faces[f], location);
            for (int t = 1; !triangulation.IsNull() && t <= triangulation->NbTriangles(); ++t) {
                for (int k = 1; k <= 3; ++k) {
                    used[sets.find(start_[f] + triangulation->Triangle(t).Value(k) - 1)] = 1;
                }
            }
        }
        return used;
    }

    void fill(WeldedFaces& result, NodeSets& sets)
    {
        Model& model = result.model;
        std::vector<int> vertex_of(start_.back(), -1);
        int vertices = 0, triangles = 0;
        const std::vector<char> used = used_sets(sets);
        for (int node = 0; node < start_.back(); ++node) {
            const int set = sets.find(node);
            vertex_of[node] = set != node ? vertex_of[set] : used[node] ? vertices++ : -1;
        }
        TopLoc_Location location;
        for (const TopoDS_Face& face : faces_.faces) {
            const auto& triangulation = BRep_Tool::Triangulation(face, location);
            triangles += triangulation.IsNull() ? 0 : triangulation->NbTriangles();
        }
        model.mesh.V.resize(vertices, 3);
        model.mesh.F.resize(triangles, 3);
        model.cad_face.reserve(triangles);
        for (size_t f = 0; f < faces_.faces.size(); ++f) {
            place_vertices(static_cast<int>(f), vertex_of, sets, result);
            fill_face(static_cast<int>(f), vertex_of, result);
        }
        for (size_t e = 0; e < edge_nodes_.size(); ++e) {
            for (const std::vector<int>& nodes : edge_nodes_[e]) {
                for (size_t i = 0; i + 1 < nodes.size(); ++i) {
                    const auto [a, b] = std::minmax(vertex_of[nodes[i]], vertex_of[nodes[i + 1]]);
                    if (a != b && a >= 0) {
                        model.cad_edges.push_back({a, b, static_cast<int>(e)});
                    }
                }
            }
        }
        std::ranges::sort(model.cad_edges);
        model.cad_edges.erase(std::unique(model.cad_edges.begin(), model.cad_edges.end()), model.cad_edges.end());
    }

    /// Where several nodes became one vertex, the first one gives the place.
    void place_vertices(int f, const std::vector<int>& vertex_of, NodeSets& sets, WeldedFaces& result) const
    {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(faces_.faces[f], location);
        const gp_Trsf placement = location.Transformation();
        for (int node = start_[f]; node < start_[f + 1]; ++node) {
            if (sets.find(node) == node && vertex_of[node] >= 0) {
                const gp_Pnt p = triangulation->Node(node - start_[f] + 1).Transformed(placement);
                result.model.mesh.V.row(vertex_of[node]) << p.X(), p.Y(), p.Z();
                result.non_finite_nodes += std::isfinite(p.X() + p.Y() + p.Z()) ? 0 : 1;
            }
        }
    }

    void fill_face(int f, const std::vector<int>& vertex_of, WeldedFaces& result) const
    {
        Model& model = result.model;
        TopLoc_Location location;
        const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(faces_.faces[f], location);
        if (triangulation.IsNull() || triangulation->NbTriangles() == 0) {
            result.unmeshed.push_back(f);
            return;
        }
        const gp_Trsf placement = location.Transformation();
        const bool turned =
            (faces_.faces[f].Orientation() == TopAbs_REVERSED) != (placement.VectorialPart().Determinant() < 0);
        for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
            int a = 0, b = 0, c = 0;
            triangulation->Triangle(t).Get(a, b, c);
            const int row = static_cast<int>(model.cad_face.size());
            const auto vertex = [&](int node) { return vertex_of[start_[f] + node - 1]; };
            model.mesh.F.row(row) << vertex(a), vertex(turned ? c : b), vertex(turned ? b : c);
            model.cad_face.push_back(f);
        }
        result.folded_triangles += count_folded(f, vertex_of, model.mesh.V);
    }

    /// Counts with the places that the vertices have after joining, which can be others than the nodes'.
    int count_folded(int f, const std::vector<int>& vertex_of, const Positions& V) const
    {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(faces_.faces[f], location);
        if (!triangulation->HasUVNodes()) {
            return 0;
        }
        const FaceNormals normals(faces_.faces[f]);
        const gp_Trsf placement = location.Transformation();
        const double hand = placement.VectorialPart().Determinant() < 0 ? -1 : 1;
        int folded = 0;
        for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
            Vec3 corner[3];
            gp_XY middle(0, 0);
            for (int k = 0; k < 3; ++k) {
                const int node = triangulation->Triangle(t).Value(k + 1);
                corner[k] = V.row(vertex_of[start_[f] + node - 1]);
                middle += triangulation->UVNode(node).XY() / 3;
            }
            auto normal = normals.at(middle.X(), middle.Y());
            if (normal) {
                const gp_Vec placed = hand * gp_Vec(normal->x(), normal->y(), normal->z()).Transformed(placement);
                normal = Vec3(placed.X(), placed.Y(), placed.Z()).normalized();
            }
            folded += facing(corner[0], corner[1], corner[2], normal) < 0;
        }
        return folded;
    }

    const CadFaces& faces_;
    std::vector<int> start_;                                ///< first node of each face in the common numbering
    std::vector<std::vector<std::vector<int>>> edge_nodes_; ///< per edge its subdivision(s)
    TopTools_IndexedMapOfShape vertices_;
    std::vector<int> vertex_node_;
};

} // namespace

WeldedFaces weld_faces(const CadFaces& faces) { return Welder(faces).weld(); }

} // namespace tapeline
