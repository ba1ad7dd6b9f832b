// Compares tipspeed with other optimisers: pagmo2 and NLopt, on one thread.
//
// First on the objective as a user of those libraries would write it, in plain
// scalar C++ with nothing of src/core, for speed; then on tipspeed's own
// accurate misfit, to see whether anybody finds a lower one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlopt.hpp>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/types.hpp>

extern "C" {
#include "core/calibrate.h"
#include "core/misfit.h"
#include "core/params.h"
#include "core/polish.h"
#include "measure.h"
}

namespace
{

using Theta = std::vector<double>; // in the order of PARAMS
using Objective = std::function<double(const double *)>;

// -- The objective, plainly ---------------------------------------------------

constexpr std::size_t CLASSES = 40, POINTS = 2 * CLASSES, NODES = 81;

double
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
class PlainMisfit
{
      public:
	explicit PlainMisfit(const struct misfit &m)
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
		make_points(split(edges));
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

	void make_points(const std::vector<double> &end)
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

// -- The other optimisers -----------------------------------------------------

struct Found {
	Theta x;
	double misfit, seconds; // misfit: as the optimiser saw it
	double evaluations;
};

// pagmo's idea of a problem.
struct Problem {
	const Objective *objective = nullptr;

	pagmo::vector_double fitness(const pagmo::vector_double &x) const
	{
		return {(*objective)(x.data())};
	}

	std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const
	{
		struct bounds b = bounds_default();
		return {{b.lower, b.lower + PARAM_COUNT},
		    {b.upper, b.upper + PARAM_COUNT}};
	}
};

Found
evolve(const Objective &objective, const pagmo::algorithm &algorithm,
    std::size_t size, unsigned seed)
{
	double start = measure_now();
	pagmo::population pop{pagmo::problem{Problem{&objective}}, size, seed};
	pop = algorithm.evolve(pop);
	return {pop.champion_x(), pop.champion_f()[0], measure_now() - start,
	    double(pop.get_problem().get_fevals())};
}

double
nlopt_misfit(unsigned, const double *x, double *, void *objective)
{
	return (*static_cast<const Objective *>(objective))(x);
}

Found
nlopt_search(const Objective &objective, nlopt::algorithm algorithm,
    unsigned population, int most, unsigned seed)
{
	double start = measure_now();
	struct bounds b = bounds_default();
	std::mt19937_64 random(seed);
	Found found{Theta(PARAM_COUNT), 0, 0, 0};
	for (std::size_t j = 0; j < PARAM_COUNT; j++)
		found.x[j] = std::uniform_real_distribution<double>(
		    b.lower[j], b.upper[j])(random);
	nlopt::srand(seed);
	nlopt::opt opt(algorithm, PARAM_COUNT);
	opt.set_lower_bounds({b.lower, b.lower + PARAM_COUNT});
	opt.set_upper_bounds({b.upper, b.upper + PARAM_COUNT});
	opt.set_min_objective(
	    nlopt_misfit, const_cast<Objective *>(&objective));
	opt.set_maxeval(most);
	if (population > 0)
		opt.set_population(population);
	opt.optimize(found.x, found.misfit);
	found.seconds = measure_now() - start;
	found.evaluations = opt.get_numevals();
	return found;
}

// An optimiser as it is run here.  exact: also runs on the accurate misfit,
// where those of pagmo stop at differences of `tolerance`, not at their
// default of 1e-6.
struct Peer {
	const char *name;
	bool exact;
	std::function<Found(const Objective &, double tolerance, unsigned seed)>
	    search;
};

const double PAGMO_DEFAULT = 1e-6, PAGMO_EXACT = 1e-13;

const std::vector<Peer> PEERS = {
    {"pagmo2 sga 8000 x 800", false,
	[](const Objective &o, double, unsigned seed) {
		return evolve(o,
		    pagmo::algorithm{pagmo::sga{800, 0.9, 1., 0.02, 1., 2,
			"exponential", "polynomial", "tournament", seed}},
		    8000, seed);
	}},
    {"pagmo2 de 100 x 2000", true,
	[](const Objective &o, double tolerance, unsigned seed) {
		return evolve(o,
		    pagmo::algorithm{pagmo::de{
			2000, 0.8, 0.9, 2, tolerance, tolerance, seed}},
		    100, seed);
	}},
    {"pagmo2 cmaes 100 x 2000", true,
	[](const Objective &o, double tolerance, unsigned seed) {
		return evolve(o,
		    pagmo::algorithm{pagmo::cmaes{2000, -1, -1, -1, -1, 0.5,
			tolerance, tolerance, false, true, seed}},
		    100, seed);
	}},
    {"NLopt CRS2_LM, 80", true,
	[](const Objective &o, double, unsigned seed) {
		return nlopt_search(o, nlopt::GN_CRS2_LM, 80, 200000, seed);
	}},
    {"NLopt ISRES", true,
	[](const Objective &o, double, unsigned seed) {
		return nlopt_search(o, nlopt::GN_ISRES, 0, 200000, seed);
	}},
    {"NLopt ESCH", false,
	[](const Objective &o, double, unsigned seed) {
		return nlopt_search(o, nlopt::GN_ESCH, 0, 6400000, seed);
	}},
};

// -- Tables -------------------------------------------------------------------

struct params
params_of(const double *theta)
{
	struct params p;
	for (std::size_t j = 0; j < PARAM_COUNT; j++)
		params_set(&p, j, theta[j]);
	return p;
}

// What a row says of several seeds; misfits on the accurate objective.
struct Row {
	std::string name;
	std::vector<double> seconds, evaluations, misfit;
};

Row
tipspeed_row(const char *what, const struct site *site,
    struct calibrate_options options, unsigned seeds)
{
	Row row{"tipspeed " + std::string(what) + ", " +
		    std::to_string(options.threads) +
		    (options.threads > 1 ? " threads" : " thread"),
	    {}, {}, {}};
	for (unsigned seed = 1; seed <= seeds; seed++) {
		struct fit fit;
		options.seed = seed;
		row.seconds.push_back(measure_calibrate(site, &options, &fit));
		row.evaluations.push_back(double(fit.evaluations));
		row.misfit.push_back(fit.misfit);
	}
	return row;
}

struct calibrate_options
ordinary(unsigned threads)
{
	struct calibrate_options o = calibrate_options_default();
	o.threads = threads;
	return o;
}

double
middle(std::vector<double> x)
{
	return measure_median(x.data(), x.size());
}

double
least(const std::vector<double> &x)
{
	return *std::min_element(x.begin(), x.end());
}

double
most(const std::vector<double> &x)
{
	return *std::max_element(x.begin(), x.end());
}

void
print_row(const Row &row, double best, double full_all, double full_one)
{
	double seconds = middle(row.seconds), n = middle(row.evaluations);
	std::printf("%-30s%9.0f%9.3f%9.3f%14.7e%10.1e%10.1e%8.2f%8.2f\n",
	    row.name.c_str(), n, seconds, n / seconds / 1e6, least(row.misfit),
	    least(row.misfit) / best - 1, most(row.misfit) / best - 1,
	    seconds / full_all, seconds / full_one);
}

std::vector<Row>
race(const struct site *site, struct misfit *accurate, unsigned seeds)
{
	unsigned all = measure_threads();
	Objective plain = PlainMisfit(*accurate);
	std::vector<Row> rows = {
	    tipspeed_row("8000 x 800", site, measure_full_run(all), seeds),
	    tipspeed_row("8000 x 800", site, measure_full_run(1), seeds),
	    tipspeed_row("ordinary", site, ordinary(all), seeds),
	    tipspeed_row("ordinary", site, ordinary(1), seeds)};
	for (const Peer &peer : PEERS) {
		Row row{peer.name, {}, {}, {}};
		for (unsigned seed = 1; seed <= seeds; seed++) {
			Found f = peer.search(plain, PAGMO_DEFAULT, seed);
			struct params p = params_of(f.x.data());
			row.seconds.push_back(f.seconds);
			row.evaluations.push_back(f.evaluations);
			row.misfit.push_back(misfit_at(accurate, &p));
		}
		rows.push_back(row);
	}
	return rows;
}

void
print_race(const struct site *site, unsigned seeds)
{
	struct misfit *accurate = measure_misfit(site, false);
	std::size_t n_sieve = PlainMisfit(*accurate).n_sieve();
	std::printf("\nSpeed, %s: plain objective, %zu classes, %zu sieves, "
		    "%zu speeds; %u seeds\n\n",
	    site->name, CLASSES, n_sieve, accurate->n_run, seeds);
	std::vector<Row> rows = race(site, accurate, seeds);
	std::printf("%-30s%9s%9s%9s%14s%10s%10s%8s%8s\n", "", "evalu-", "",
	    "million", "best accur.", "gap, best", "gap,worst", "times",
	    "times");
	std::printf("%-30s%9s%9s%9s%14s%10s%10s%8s%8s\n", "optimiser", "ations",
	    "seconds", "/second", "misfit", "seed", "seed", "full", "full 1");
	double best = INFINITY;
	for (const Row &row : rows)
		best = std::min(best, least(row.misfit));
	for (const Row &row : rows)
		print_row(row, best, middle(rows[0].seconds),
		    middle(rows[1].seconds));
	misfit_free(accurate);
}

// The lowest misfit a peer found on the accurate objective, and the lowest
// that tipspeed's polish makes of what peers found.
struct Exact {
	std::vector<double> peer; // by peer
	double polished = INFINITY;
	Row tipspeed;
};

Exact
exact_search(const struct site *site, unsigned seeds)
{
	Exact e;
	struct misfit *m = measure_misfit(site, false);
	struct bounds bounds = bounds_default();
	struct polish *polish = polish_new(m);
	Objective accurate = [m](const double *theta) {
		struct params p = params_of(theta);
		return misfit_at(m, &p);
	};
	for (const Peer &peer : PEERS) {
		if (!peer.exact)
			continue;
		double best = INFINITY;
		for (unsigned seed = 1; seed <= seeds; seed++) {
			Found f = peer.search(accurate, PAGMO_EXACT, seed);
			struct params p = params_of(f.x.data());
			best = std::min(best, f.misfit);
			e.polished = std::min(e.polished,
			    polish_run(polish, &bounds, 1000, &p).misfit);
		}
		e.peer.push_back(best);
	}
	e.tipspeed =
	    tipspeed_row("ordinary", site, ordinary(measure_threads()), seeds);
	polish_free(polish);
	misfit_free(m);
	return e;
}

// Returns the gap between tipspeed's worst seed and the best of the others.
double
print_exact(const struct site *site, unsigned seeds)
{
	char stem[64];
	Exact e = exact_search(site, seeds);
	double peers = std::min(e.polished, least(e.peer));
	double best = std::min(peers, least(e.tipspeed.misfit));
	double gap = (most(e.tipspeed.misfit) - peers) / peers;
	std::printf("%-14s%15.8e%9.3f", measure_stem(site, stem),
	    most(e.tipspeed.misfit), middle(e.tipspeed.seconds));
	for (double misfit : e.peer)
		std::printf("%10.1e", misfit / best - 1);
	std::printf("%10.1e%11.1e\n", e.polished / best - 1, gap);
	std::fflush(stdout);
	return gap;
}

void
print_exactness(const std::vector<struct site *> &sites, unsigned seeds)
{
	double worst = -INFINITY;
	std::printf("\nExactness: tipspeed's ordinary calibration (worst of %u "
		    "seeds) and the best of %u\nseeds of each peer on the same "
		    "accurate misfit; peers relative to the best known\n\n",
	    seeds, seeds);
	std::printf("%-14s%15s%9s%10s%10s%10s%10s%10s%11s\n", "site",
	    "tipspeed", "seconds", "de", "cmaes", "CRS2_LM", "ISRES",
	    "polished", "gap");
	for (const struct site *site : sites)
		worst = std::max(worst, print_exact(site, seeds));
	std::printf("\nlargest gap %.1e\n", worst);
}

int
usage()
{
	std::fprintf(stderr, "usage: peers DATA_DIR [SITE...]\n"
			     "       peers DATA_DIR all SEEDS\n");
	return 2;
}

} // namespace

int
main(int argc, char **argv)
{
	enum { SEEDS = 2 };
	if (argc < 2)
		return usage();
	bool all = argc > 2 && std::strcmp(argv[2], "all") == 0;
	int seeds = all && argc == 4 ? std::atoi(argv[3]) : int(SEEDS);
	if ((all && argc != 4) || seeds < 1)
		return usage();
	struct measure_sites data = measure_read_sites(argv[1]);
	std::vector<std::string> names(argv + 2, argv + argc);
	std::vector<struct site *> sites(data.site, data.site + data.n);
	if (names.empty())
		names = {"Tierp", "Össjö", "Bro"};
	if (!all) {
		sites.clear();
		for (const std::string &name : names)
			sites.push_back(measure_site(&data, name.c_str()));
	}
	measure_print_machine();
	for (const struct site *site : sites)
		if (!all)
			print_race(site, unsigned(seeds));
	print_exactness(sites, unsigned(seeds));
	measure_free_sites(&data);
	return std::ferror(stdout) != 0;
}
