// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/bezier_spans.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tapeline::spline {

BezierSpans::BezierSpans(const BSplineData& data)
{
    const std::vector<Eigen::Vector4d> poles = homogeneous(data);
    const int p = data.degree, n = static_cast<int>(poles.size());
    const bool rational = std::ranges::any_of(data.weights, [&](double w) { return w != data.weights.front(); });
    for (int k = p; k < n; ++k) {
        if (data.knots[k] == data.knots[k + 1]) {
            continue;
        }
        BezierSpan span;
        span.first = data.knots[k];
        span.last = data.knots[k + 1];
        for (int j = 0; j <= p; ++j) {
            std::vector<double> arguments(p, span.first);
            std::fill_n(arguments.begin(), j, span.last);
            const Eigen::Vector4d pole = blossom(data.knots, poles, p, k, arguments);
            span.points.push_back(pole.head<3>() / pole[3]);
            if (rational) {
                span.weights.push_back(pole[3]);
            }
            span.box.extend(span.points.back());
        }
        spans_.push_back(std::move(span));
    }
    root_ = build(0, static_cast<int>(spans_.size()));
}

const BezierSpan& BezierSpans::span_at(double t) const
{
    const auto after = std::ranges::upper_bound(spans_, t, {}, &BezierSpan::first);
    return after == spans_.begin() ? spans_.front() : *(after - 1);
}

namespace {

/// Value and first two derivatives of a polynomial in Bernstein form on [0, 1]; overwrites the coefficients.
template <class T>
std::array<T, 3> casteljau(T* c, int degree, double s, const T& zero)
{
    std::array<T, 3> result{zero, zero, zero};
    for (int r = degree; r > 0; --r) {
        if (r == 2) {
            result[2] = degree * (degree - 1) * ((c[2] - c[1]) - (c[1] - c[0]));
        }
        if (r == 1) {
            result[1] = degree * (c[1] - c[0]);
        }
        for (int i = 0; i < r; ++i) {
            c[i] = s <= 0.5 ? T(c[i] + s * (c[i + 1] - c[i])) : T(c[i + 1] - (1 - s) * (c[i + 1] - c[i]));
        }
    }
    result[0] = c[0];
    return result;
}

constexpr int max_degree = BSplineData::max_degree;

} // namespace

CurveValue BezierSpan::value(double t) const
{
    const int degree = static_cast<int>(points.size()) - 1;
    const double length = last - first;
    const double s = t <= first ? 0 : t >= last ? 1 : (t - first) / length;
    CurveValue result;
    if (weights.empty()) {
        std::array<Vec3, max_degree + 1> c;
        c.fill(Vec3::Zero());
        for (int i = 0; i <= degree; ++i) {
            c[i] = points[i] - points[0];
        }
        const auto d = casteljau<Vec3>(c.data(), degree, s, Vec3::Zero());
        result = {points[0] + d[0], d[1] / length, d[2] / (length * length)};
    } else {
        std::array<Eigen::Vector4d, max_degree + 1> c;
        c.fill(Eigen::Vector4d::Zero());
        for (int i = 0; i <= degree; ++i) {
            c[i] << weights[i] * (points[i] - points[0]), weights[i];
        }
        const auto d = casteljau<Eigen::Vector4d>(c.data(), degree, s, Eigen::Vector4d::Zero());
        const double w = d[0][3], w1 = d[1][3], w2 = d[2][3];
        const Vec3 r = d[0].head<3>() / w;
        const Vec3 r1 = (d[1].head<3>() - w1 * r) / w;
        const Vec3 r2 = (d[2].head<3>() - 2 * w1 * r1 - w2 * r) / w;
        result = {points[0] + r, r1 / length, r2 / (length * length)};
    }
    if (s == 0 || s == 1) {
        result.point = s == 0 ? points.front() : points.back();
    }
    return result;
}

int BezierSpans::build(int begin, int end)
{
    if (end - begin == 1) {
        nodes_.push_back({spans_[begin].box, -1, begin});
    } else {
        const int middle = (begin + end) / 2;
        const int left = build(begin, middle), right = build(middle, end);
        nodes_.push_back({nodes_[left].box.merged(nodes_[right].box), left, right});
    }
    return static_cast<int>(nodes_.size()) - 1;
}

void BezierSpans::descend(int node, const Vec3& p, double& bound, const std::function<double(int)>& visit) const
{
    const Node& here = nodes_[node];
    if (here.box.squaredExteriorDistance(p) > bound) {
        return;
    }
    if (here.left < 0) {
        bound = std::min(bound, visit(here.right));
        return;
    }
    const double to_left = nodes_[here.left].box.squaredExteriorDistance(p);
    const double to_right = nodes_[here.right].box.squaredExteriorDistance(p);
    const bool left_first = to_left <= to_right;
    descend(left_first ? here.left : here.right, p, bound, visit);
    descend(left_first ? here.right : here.left, p, bound, visit);
}

void BezierSpans::visit_near(const Vec3& p, double bound, const std::function<double(int)>& visit) const
{
    descend(root_, p, bound, visit);
}

namespace {

double binomial(int n, int k)
{
    double result = 1;
    for (int i = 1; i <= k; ++i) {
        result = result * (n - k + i) / i;
    }
    return result;
}

/// Bernstein coefficients of the product of two polynomials given in Bernstein form.
template <class A, class B, class Multiply>
std::vector<double> product(const std::vector<A>& a, const std::vector<B>& b, const Multiply& multiply)
{
    const int m = static_cast<int>(a.size()) - 1, n = static_cast<int>(b.size()) - 1;
    std::vector<double> choose_m(m + 1), choose_n(n + 1), result(m + n + 1, 0.0);
    for (int i = 0; i <= m; ++i) {
        choose_m[i] = binomial(m, i);
    }
    for (int j = 0; j <= n; ++j) {
        choose_n[j] = binomial(n, j);
    }
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            result[i + j] += choose_m[i] * choose_n[j] * multiply(a[i], b[j]);
        }
    }
    for (int k = 0; k <= m + n; ++k) {
        result[k] /= binomial(m + n, k);
    }
    return result;
}

template <class T>
std::vector<T> derivative(const std::vector<T>& a)
{
    std::vector<T> result;
    for (size_t i = 0; i + 1 < a.size(); ++i) {
        result.push_back((a[i + 1] - a[i]) * static_cast<double>(a.size() - 1));
    }
    return result;
}

template <class T>
double largest(const std::vector<T>& values)
{
    double result = 0;
    for (const T& value : values) {
        if constexpr (std::is_same_v<T, double>) {
            result = std::max(result, std::abs(value));
        } else {
            result = std::max(result, value.norm());
        }
    }
    return result;
}

struct RootFinder {
    double noise;
    std::vector<double> roots;

    static double value(const std::vector<double>& c, double s)
    {
        std::vector<double> d = c;
        for (size_t r = 1; r < d.size(); ++r) {
            for (size_t i = 0; i + r < d.size(); ++i) {
                d[i] += s * (d[i + 1] - d[i]);
            }
        }
        return d[0];
    }

    /// One sign change between the ends: regula falsi (Illinois), kept inside the bracket.
    static double bracketed(const std::vector<double>& c)
    {
        double low = 0, high = 1, at_low = c.front(), at_high = c.back();
        int side = 0;
        for (int step = 0; step < 60 && high - low > 1e-14; ++step) {
            double s = (low * at_high - high * at_low) / (at_high - at_low);
            if (!(s > low && s < high)) {
                s = 0.5 * (low + high);
            }
            const double f = value(c, s);
            if (f == 0) {
                return s;
            }
            if ((f > 0) == (at_high > 0)) {
                high = s;
                at_high = f;
                at_low *= side == 1 ? 0.5 : 1;
                side = 1;
            } else {
                low = s;
                at_low = f;
                at_high *= side == -1 ? 0.5 : 1;
                side = -1;
            }
        }
        return std::abs(at_low) < std::abs(at_high) ? low : high;
    }

    void search(const std::vector<double>& c, double a, double b, int depth)
    {
        int changes = 0;
        double sign = 0, size = 0;
        for (const double value : c) {
            size = std::max(size, std::abs(value));
            if (value != 0) {
                changes += sign * value < 0 ? 1 : 0;
                sign = value > 0 ? 1 : -1;
            }
        }
        if (size <= noise || (depth == 0 && changes > 0)) {
            roots.push_back(0.5 * (a + b));
            return;
        }
        if (changes == 0) {
            return;
        }
        if (changes == 1 && c.front() * c.back() < 0) {
            roots.push_back(a + (b - a) * bracketed(c));
            return;
        }
        std::vector<double> left, right(c.size()), d = c;
        for (size_t r = 0; r < c.size(); ++r) {
            left.push_back(d.front());
            right[c.size() - 1 - r] = d[c.size() - 1 - r];
            for (size_t i = 0; i + r + 1 < c.size(); ++i) {
                d[i] = 0.5 * (d[i] + d[i + 1]);
            }
        }
        const double middle = 0.5 * (a + b);
        search(left, a, middle, depth - 1);
        if (left.back() == 0) {
            roots.push_back(middle);
        }
        search(right, middle, b, depth - 1);
    }
};

} // namespace

FootPolynomial foot_polynomial(const BezierSpan& span, const Vec3& p)
{
    std::vector<Vec3> m(span.points.size());
    for (size_t i = 0; i < m.size(); ++i) {
        m[i] = (span.weights.empty() ? 1 : span.weights[i]) * (span.points[i] - p);
    }
    const auto dot = [](const Vec3& a, const Vec3& b) { return a.dot(b); };
    const auto times = [](double a, double b) { return a * b; };
    const std::vector<Vec3> dm = derivative(m);
    FootPolynomial result{product(m, dm, dot), largest(m) * largest(dm)};
    if (!span.weights.empty()) {
        // |M / w|² / 2 has the slope M · (M' w - M w') / w³.
        result.coefficients = product(result.coefficients, span.weights, times);
        const std::vector<double> second = product(product(m, m, dot), derivative(span.weights), times);
        for (size_t i = 0; i < second.size(); ++i) {
            result.coefficients[i] -= second[i];
        }
        result.scale =
            result.scale * largest(span.weights) + largest(m) * largest(m) * largest(derivative(span.weights));
    }
    return result;
}

std::vector<double> bernstein_roots(const FootPolynomial& polynomial)
{
    RootFinder finder{1e-14 * polynomial.scale, {}};
    finder.search(polynomial.coefficients, 0, 1, 46);
    return finder.roots;
}

} // namespace tapeline::spline
