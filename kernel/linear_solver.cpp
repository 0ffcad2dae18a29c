// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/linear_solver.h"

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>

extern "C" void openblas_set_num_threads(int);

namespace tapeline {

namespace {

constexpr int cholmod_from = 20000;
using Simplicial = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
using Supernodal = Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>;

} // namespace

struct CholeskySolver::Impl {
    std::unique_ptr<Simplicial> small;
    std::unique_ptr<Supernodal> large;
};

CholeskySolver::CholeskySolver() : impl_(std::make_unique<Impl>()) {}
CholeskySolver::~CholeskySolver() = default;
CholeskySolver::CholeskySolver(CholeskySolver&&) noexcept = default;
CholeskySolver& CholeskySolver::operator=(CholeskySolver&&) noexcept = default;

bool CholeskySolver::factorize(const Eigen::SparseMatrix<double>& A)
{
    impl_->small.reset();
    impl_->large.reset();
    if (A.rows() < cholmod_from) {
        impl_->small = std::make_unique<Simplicial>(A);
        return impl_->small->info() == Eigen::Success && impl_->small->vectorD().minCoeff() > 0;
    }
    // More than one BLAS thread would make the bytes of the result depend on their number.
    openblas_set_num_threads(1);
    impl_->large = std::make_unique<Supernodal>();
    impl_->large->cholmod().print = 0;
    impl_->large->cholmod().nmethods = 1;
    impl_->large->cholmod().method[0].ordering = CHOLMOD_AMD;
    impl_->large->compute(A);
    return impl_->large->info() == Eigen::Success;
}

Eigen::MatrixXd CholeskySolver::solve(const Eigen::MatrixXd& B) const
{
    return impl_->small ? Eigen::MatrixXd(impl_->small->solve(B)) : Eigen::MatrixXd(impl_->large->solve(B));
}

} // namespace tapeline
