// The misfit as a user of an optimiser's library would write it: plain scalar
// C++, nothing of src/core but the site's numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TIPSPEED_BENCH_PLAIN_H
#define TIPSPEED_BENCH_PLAIN_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

extern "C" {
#include "core/search/misfit.h"
}

namespace plain
{

constexpr std::size_t CLASSES = 40, POINTS = 2 * CLASSES, NODES = 81;

inline double
passing_at(const struct psd &psd, double x)
{
	if (x >= psd.size[0])
		return psd.passing[0];
	for (std::size_t i = 1; i < psd.n; i++)
		if (x >= psd.size[i]) {
			double t = std::log(x / psd.size[i]) /
				   std::log(psd.size[i - 1] / psd.size[i]);
			return psd.passing[i] +
			       t * (psd.passing[i - 1] - psd.passing[i]);
		}
	return psd.passing[psd.n - 1];
}

// P(s) = F(s) + sum over x > s of S(x) B(s/x) dF(x), 40 classes that end at
// every sieve, two Gauss points a class; B from 81 nodes of u, 8 an octave.
class Misfit
{
      public:
	explicit Misfit(const struct misfit &m)
	{
		std::vector<double> sieves, edges;
		for (std::size_t r = 0; r < m.n_run; r++) {
			const struct misfit_run &run = m.run[r];
			sieves.insert(
			    sieves.end(), run.sieve, run.sieve + run.n);
			edges.insert(edges.end(), run.feed.size,
			    run.feed.size + run.feed.n);
		}
		falling(sieves);
		edges.insert(edges.end(), sieves.begin(), sieves.end());
		falling(edges);
		make_quadrature_points(split(edges));
		for (double s : sieves)
			if (s < edges[0])
				add_sieve(s);
		for (std::size_t r = 0; r < m.n_run; r++)
			add_run(m.run[r]);
		for (std::size_t j = 0; j < NODES; j++)
			u[j] = std::exp2(-double(j) / 8);
	}

	double operator()(const double *theta) const
	{
		std::array<double, NODES> below;
		double total = daughters(theta, below), sum = 0;
		std::array<double, POINTS> power;
		for (std::size_t q = 0; q < POINTS; q++)
			power[q] = std::exp(theta[6] * log_x[q]);
		for (const Run &run : runs)
			sum += run_misfit(run, theta, power, below, total);
		return std::isfinite(sum) ? sum : 1e6;
	}

	std::size_t n_sieve() const
	{
		return targets.size();
	}

      private:
	// Where B(s/x) lies in the table of nodes, for a sieve and a point.
	struct Place {
		std::size_t node;
		double share;
	};
	struct Target {
		double size;
		std::vector<Place> above; // points coarser than the sieve
	};
	struct Run {
		double energy;
		std::array<double, POINTS> mass;
		std::vector<double> feed, measured, weight; // by sieve
	};

	std::array<double, POINTS> log_x, width; // of a point's half class
	std::array<double, NODES> u;
	std::vector<Target> targets;
	std::vector<Run> runs;

	static void falling(std::vector<double> &x)
	{
		std::sort(x.begin(), x.end(), std::greater<double>());
		x.erase(std::unique(x.begin(), x.end()), x.end());
	}

	// Ends of 40 classes, ln x: the widest are split first.
	static std::vector<double> split(const std::vector<double> &edges)
	{
		std::size_t n = edges.size() - 1;
		if (n > CLASSES)
			throw std::runtime_error("more than 40 intervals");
		std::vector<int> parts(n, 1);
		auto wide = [&](std::size_t i) {
			return std::log(edges[i] / edges[i + 1]) / parts[i];
		};
		for (std::size_t k = n; k < CLASSES; k++) {
			std::size_t widest = 0;
			for (std::size_t i = 1; i < n; i++)
				if (wide(i) > wide(widest) * (1 + 1e-9))
					widest = i;
			parts[widest]++;
		}
		std::vector<double> end{std::log(edges[0])};
		for (std::size_t i = 0; i < n; i++)
			for (int k = 1; k <= parts[i]; k++)
				end.push_back(std::log(edges[i]) - k * wide(i));
		return end;
	}

	void make_quadrature_points(const std::vector<double> &end)
	{
		for (std::size_t c = 0; c < CLASSES; c++) {
			double middle = (end[c] + end[c + 1]) / 2;
			double half = (end[c] - end[c + 1]) / 2;
			log_x[2 * c] = middle + half / std::sqrt(3.0);
			log_x[2 * c + 1] = middle - half / std::sqrt(3.0);
			width[2 * c] = width[2 * c + 1] = half;
		}
	}

	void add_sieve(double s)
	{
		Target t{s, {}};
		for (std::size_t q = 0; q < POINTS && log_x[q] > std::log(s);
		     q++) {
			double at =
			    8 * (log_x[q] - std::log(s)) / std::log(2.0);
			bool finest = at >= NODES - 1;
			std::size_t node = finest ? NODES - 2 : std::size_t(at);
			t.above.push_back(
			    {node, finest ? 1 : at - double(node)});
		}
		targets.push_back(t);
	}

	void add_run(const struct misfit_run &from)
	{
		Run run;
		run.energy = from.speed * from.speed / 2;
		for (std::size_t q = 0; q < POINTS; q++) {
			double h = width[q] * 1e-3, x = log_x[q];
			run.mass[q] =
			    (passing_at(from.feed, std::exp(x + h)) -
				passing_at(from.feed, std::exp(x - h))) /
			    (2 * h) * width[q];
		}
		for (const Target &t : targets) {
			run.feed.push_back(passing_at(from.feed, t.size));
			run.measured.push_back(0);
			run.weight.push_back(0);
			for (std::size_t i = 0; i < from.n; i++)
				if (from.sieve[i] == t.size) {
					run.measured.back() = from.measured[i];
					run.weight.back() = from.weight[i];
				}
		}
		runs.push_back(run);
	}

	// Integral of p(u) d ln u from 2^-10 up to each node; the last is 0.
	double daughters(
	    const double *beta, std::array<double, NODES> &below) const
	{
		double sum = 0, before = 0;
		for (std::size_t j = NODES; j-- > 0;) {
			double p =
			    beta[0] +
			    u[j] *
				(beta[1] + u[j] * (beta[2] + u[j] * beta[3]));
			p = p > 0 ? p : 0;
			if (j < NODES - 1)
				sum += (before + p) * (std::log(2.0) / 16);
			below[j] = sum;
			before = p;
		}
		return sum;
	}

	double run_misfit(const Run &run, const double *theta,
	    const std::array<double, POINTS> &power,
	    const std::array<double, NODES> &below, double total) const
	{
		std::array<double, POINTS> broken;
		for (std::size_t q = 0; q < POINTS; q++) {
			double over = power[q] * run.energy - theta[5];
			broken[q] =
			    over > 0
				? run.mass[q] * (1 - std::exp(-theta[4] * over))
				: 0;
		}
		double misfit = 0;
		for (std::size_t s = 0; s < targets.size(); s++) {
			const std::vector<Place> &above = targets[s].above;
			double sum = 0;
			for (std::size_t q = 0; q < above.size(); q++) {
				const double *B = &below[above[q].node];
				sum += broken[q] *
				       (B[0] + above[q].share * (B[1] - B[0]));
			}
			double P = run.feed[s] + (total > 0 ? sum / total : 0);
			double d = run.weight[s] * (P - run.measured[s]);
			misfit += d * d;
		}
		return misfit;
	}
};

} // namespace plain

#endif
