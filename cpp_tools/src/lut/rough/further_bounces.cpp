// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "rough/further_bounces.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "films/column.h"
#include "nacre/lut/rough_slices.h"
#include "nacre/optics/microsurface_walk.h"

namespace nacre::lut {
namespace {

using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::VectorXd;

// Facet cosines, linear in between. What further bounces add is a mean over many of them.
constexpr Eigen::Index kNodes = 17;
// Paths with more bounces carry less than 1e-3 of the light at alpha 1.
constexpr std::size_t kMostBounces = 9;
constexpr std::uint64_t kPaths = 20'000;
constexpr std::size_t kBandNm = 5;
constexpr Eigen::Index kBands = 1 + (spectral::kWavelengths - 1) / kBandNm;

/// Where paths of one view and roughness meet facets. Pairs as they come; from the third bounce on
/// the facets are taken for independent of each other.
struct WalkStatistics {
    MatrixXd pairs = MatrixXd::Zero(kNodes, kNodes);
    std::array<VectorXd, kMostBounces + 1> first;  ///< of paths with 3 bounces and more
    VectorXd later = VectorXd::Zero(kNodes);       ///< of those paths; sums to 1

    WalkStatistics() { first.fill(VectorXd::Zero(kNodes)); }
};

struct Hat {
    Eigen::Index low;
    double t;

    explicit Hat(double cosine)
    {
        const double x = cosine * (kNodes - 1);
        low = std::min(static_cast<Eigen::Index>(x), kNodes - 2);
        t = x - static_cast<double>(low);
    }
    void add(VectorXd& sum, double weight) const
    {
        sum[low] += weight * (1.0 - t);
        sum[low + 1] += weight * t;
    }
};

WalkStatistics statistics(double cos_theta, double alpha)
{
    constexpr double kShare = 1.0 / static_cast<double>(kPaths);
    WalkStatistics result;
    const auto count = [&result](std::span<const double> cosines, const auto&) {
        const std::size_t bounces = cosines.size();
        if (bounces < 2 || bounces > kMostBounces) return;
        const Hat first(cosines[0]);
        if (bounces == 2) {
            VectorXd column = VectorXd::Zero(kNodes);
            Hat(cosines[1]).add(column, kShare);
            result.pairs.row(first.low) += (1.0 - first.t) * column.transpose();
            result.pairs.row(first.low + 1) += first.t * column.transpose();
            return;
        }
        first.add(result.first[bounces], kShare);
        for (const double cosine : cosines.subspan(1)) Hat(cosine).add(result.later, 1.0);
    };
    const double mu = std::max(cos_theta, 0.02);
    optics::walk_microsurface({.view = {std::sqrt(1.0 - mu * mu), 0.0, mu},
                               .alpha = {alpha, alpha},
                               .paths = kPaths,
                               .max_bounces = static_cast<int>(kMostBounces)},
                              count);
    result.later /= std::max(1.0, result.later.sum());
    return result;
}

/// The same for every film; made once.
const std::vector<WalkStatistics>& all_statistics()
{
    static const auto kAll = [] {
        std::vector<WalkStatistics> all(kRoughSlices * kFurtherColumns);
        tbb::parallel_for(std::size_t{0}, all.size(), [&all](std::size_t i) {
            const std::size_t slice = 1 + i / kFurtherColumns;
            const double roughness = static_cast<double>(slice) / kRoughSlices;
            const double cos_theta =
                static_cast<double>(i % kFurtherColumns) / (kFurtherColumns - 1);
            all[i] = statistics(cos_theta, roughness * roughness);
        });
        return all;
    }();
    return kAll;
}

/// The bands of 5 nm that have a weight in a colour, which stand for the 471 wavelengths.
struct WeightedBands {
    std::vector<std::size_t> band;                        ///< ascending
    Eigen::Matrix<double, 3, Eigen::Dynamic> of_channel;  ///< a column for each of them

    explicit WeightedBands(const spectral::ColourWeights& weights)
    {
        Eigen::Matrix<double, 3, Eigen::Dynamic> all =
            Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, kBands);
        for (std::size_t w = 0; w < spectral::kWavelengths; ++w) {
            const auto low = std::min(static_cast<Eigen::Index>(w / kBandNm), kBands - 2);
            const double t = static_cast<double>(w) / kBandNm - static_cast<double>(low);
            for (Eigen::Index c = 0; c < 3; ++c) {
                const double weight = weights.weight[static_cast<std::size_t>(c)][w];
                all(c, low) += (1.0 - t) * weight;
                all(c, low + 1) += t * weight;
            }
        }
        for (Eigen::Index b = 0; b < kBands; ++b)
            if (!all.col(b).isZero(0.0)) band.push_back(static_cast<std::size_t>(b));
        of_channel.resize(3, static_cast<Eigen::Index>(band.size()));
        for (std::size_t i = 0; i < band.size(); ++i)
            of_channel.col(static_cast<Eigen::Index>(i)) =
                all.col(static_cast<Eigen::Index>(band[i]));
    }
};

/// Which wavelengths the bands are, as a request has them.
FilmTableRequest at_bands(FilmTableRequest request, const std::vector<std::size_t>& bands)
{
    for (spectral::Sampled& channel : request.weights.weight) {
        channel.fill(0.0);
        for (const std::size_t band : bands) channel[band * kBandNm] = 1.0;
    }
    return request;
}

/// R of the facets, cosines × bands, of every row.
std::vector<MatrixXd> facet_reflectance(const FilmTableRequest& request,
                                        const std::vector<std::size_t>& bands, std::size_t rows)
{
    const double first = request.variation ? request.variation->min : 0.0;
    const double step =
        rows > 1 ? (request.variation->max - first) / static_cast<double>(rows - 1) : 0.0;
    const SpectralBlocks spectral(at_bands(request, bands));
    constexpr Eigen::Index kNone = -1;
    std::vector<Eigen::Index> column_of(spectral::kWavelengths + optics::kLanes, kNone);
    for (std::size_t i = 0; i < bands.size(); ++i)
        column_of[bands[i] * kBandNm] = static_cast<Eigen::Index>(i);
    std::vector<MatrixXd> result(rows,
                                 MatrixXd::Ones(kNodes, static_cast<Eigen::Index>(bands.size())));
    tbb::parallel_for(Eigen::Index{1}, kNodes, [&](Eigen::Index node) {
        Column column(spectral);
        column.turn_to(static_cast<double>(node) / (kNodes - 1));
        column.visit_reflectance(
            first, step, rows, [&](std::size_t row, std::size_t block, const optics::Lanes& R) {
                for (std::size_t i = 0; i < optics::kLanes; ++i) {
                    const Eigen::Index band = column_of[spectral.blocks[block].first + i];
                    if (band != kNone) result[row](node, band) = R[i];
                }
            });
    });
    return result;
}

/// Share of the light that leaves after two and more bounces, of each band.
VectorXd further(const WalkStatistics& walk, const MatrixXd& reflectance)
{
    ArrayXd sum = (walk.pairs * reflectance).cwiseProduct(reflectance).colwise().sum();
    const ArrayXd later = walk.later.transpose() * reflectance;
    ArrayXd power = later;
    for (std::size_t bounces = 3; bounces <= kMostBounces; ++bounces) {
        power *= later;
        const ArrayXd first = walk.first[bounces].transpose() * reflectance;
        sum += first * power;
    }
    return sum;
}

}  // namespace

FurtherBounces::FurtherBounces(const FilmTableRequest& request, std::size_t rows)
    : colours_(rows * kRoughSlices * kFurtherColumns)
{
    const std::vector<WalkStatistics>& walks = all_statistics();
    const WeightedBands bands(request.weights);
    const std::vector<MatrixXd> reflectance = facet_reflectance(request, bands.band, rows);
    tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
        for (std::size_t i = 0; i < walks.size(); ++i) {
            const Eigen::Vector3d colour = bands.of_channel * further(walks[i], reflectance[row]);
            colours_[row * walks.size() + i] = {colour[0], colour[1], colour[2]};
        }
    });
}

const spectral::Vec3& FurtherBounces::at(std::size_t slice, std::size_t column,
                                         std::size_t row) const
{
    return colours_[(row * kRoughSlices + slice) * kFurtherColumns + column];
}

spectral::Vec3 FurtherBounces::read(double slice, double cos_theta, std::size_t row) const
{
    const double x = cos_theta * (kFurtherColumns - 1);
    const std::size_t column = std::min(static_cast<std::size_t>(x), kFurtherColumns - 2);
    const auto low = std::min(static_cast<std::size_t>(slice), std::size_t{kRoughSlices - 1});
    const double u = x - static_cast<double>(column);
    const double v = slice_share(slice, static_cast<int>(low));
    spectral::Vec3 result{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto across = [&](std::size_t s) {
            return s == 0
                       ? 0.0
                       : (1.0 - u) * at(s - 1, column, row)[c] + u * at(s - 1, column + 1, row)[c];
        };
        result[c] = (1.0 - v) * across(low) + v * across(low + 1);
    }
    return result;
}

}  // namespace nacre::lut
