// Compares tipspeed with other optimisers: pagmo2 and NLopt, on one thread.
//
// First on the objective as a user of those libraries would write it, in plain
// scalar C++ with nothing of src/core, for speed; then on tipspeed's own
// accurate misfit, to see whether anybody finds a lower one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <random>
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
#include "core/search/calibrate.h"
#include "core/search/misfit.h"
#include "core/model/params.h"
#include "core/search/polish.h"
#include "measure.h"
}
#include "plain.h"

namespace
{

using Theta = std::vector<double>; // in the order of PARAMS
using Objective = std::function<double(const double *)>;

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
		struct bounds b = bounds_default(0);
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
	struct bounds b = bounds_default(0);
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

// An optimiser as it is run here.  small: few evaluations, so that it is run
// with several seeds, and on the accurate misfit too.
struct Peer {
	const char *name;
	bool small;
	std::function<Found(const Objective &, unsigned seed)> search;
};

// Those of pagmo would stop at differences of 1e-6, above the misfit's own.
const double STOP_AT = 1e-12;

const std::vector<Peer> PEERS = {
    {"pagmo2 sga 8000 x 800", false,
	[](const Objective &o, unsigned seed) {
		return evolve(o,
		    pagmo::algorithm{pagmo::sga{800, 0.9, 1., 0.02, 1., 2,
			"exponential", "polynomial", "tournament", seed}},
		    8000, seed);
	}},
    {"pagmo2 de 100 x 2000", true,
	[](const Objective &o, unsigned seed) {
		return evolve(o,
		    pagmo::algorithm{
			pagmo::de{2000, 0.8, 0.9, 2, STOP_AT, STOP_AT, seed}},
		    100, seed);
	}},
    {"pagmo2 cmaes 100 x 2000", true,
	[](const Objective &o, unsigned seed) {
		return evolve(o,
		    pagmo::algorithm{pagmo::cmaes{2000, -1, -1, -1, -1, 0.5,
			STOP_AT, STOP_AT, false, true, seed}},
		    100, seed);
	}},
    {"NLopt CRS2_LM, 80", true,
	[](const Objective &o, unsigned seed) {
		return nlopt_search(o, nlopt::GN_CRS2_LM, 80, 200000, seed);
	}},
    {"NLopt ISRES", true,
	[](const Objective &o, unsigned seed) {
		return nlopt_search(o, nlopt::GN_ISRES, 0, 200000, seed);
	}},
    {"NLopt ESCH", false,
	[](const Objective &o, unsigned seed) {
		return nlopt_search(o, nlopt::GN_ESCH, 0, 6400000, seed);
	}},
};

// -- Tables -------------------------------------------------------------------

struct params
params_of(const double *theta)
{
	struct params p;
	for (std::size_t j = 0; j < PARAM_COUNT; j++)
		p.at[j] = theta[j];
	return p;
}

// What a row says of several seeds.  own: the misfit as the optimiser saw it;
// misfit: the accurate one of the point found.
struct Row {
	std::string name;
	std::vector<double> seconds, evaluations, own, misfit;

	void add(double s, double n, double seen, double accurate)
	{
		seconds.push_back(s);
		evaluations.push_back(n);
		own.push_back(seen);
		misfit.push_back(accurate);
	}
};

Row
tipspeed_row(const std::string &what, const struct site *site,
    struct calibrate_options options, unsigned seeds)
{
	Row row{"tipspeed " + what + ", " + std::to_string(options.threads) +
		    (options.threads > 1 ? " threads" : " thread"),
	    {}, {}, {}, {}};
	for (unsigned seed = 1; seed <= seeds; seed++) {
		struct fit fit;
		options.seed = seed;
		double seconds = measure_calibrate(site, &options, &fit);
		row.add(
		    seconds, double(fit.evaluations), fit.misfit, fit.misfit);
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
	std::printf("%-30s%9.0f%9.3f%7.2f%11.3e%11.3e%9.1e%9.1e%7.2f%7.2f\n",
	    row.name.c_str(), n, seconds, n / seconds / 1e6, least(row.own),
	    least(row.misfit), least(row.misfit) / best - 1,
	    most(row.misfit) / best - 1, seconds / full_all,
	    seconds / full_one);
}

Row
peer_row(const Peer &peer, const Objective &objective, struct misfit *accurate,
    unsigned seeds)
{
	Row row{peer.name, {}, {}, {}, {}};
	for (unsigned seed = 1; seed <= (peer.small ? seeds : 1); seed++) {
		Found f = peer.search(objective, seed);
		struct params p = params_of(f.x.data());
		row.add(f.seconds, f.evaluations, f.misfit,
		    misfit_at(accurate, &p));
	}
	return row;
}

// The paper's size with the operators of a textbook (preset=paper).
struct calibrate_options
textbook(unsigned threads)
{
	struct calibrate_options o = measure_full_run(threads);
	o.plain = true;
	return o;
}

// tipspeed's full run comes first: on all threads, then on one.
std::vector<Row>
race(const struct site *site, const Objective &objective,
    struct misfit *accurate, unsigned seeds)
{
	unsigned all = measure_threads();
	std::vector<Row> rows = {
	    tipspeed_row("8000 x 800", site, measure_full_run(all), seeds),
	    tipspeed_row("8000 x 800", site, measure_full_run(1), seeds),
	    tipspeed_row("textbook", site, textbook(all), seeds),
	    tipspeed_row("ordinary", site, ordinary(all), seeds),
	    tipspeed_row("ordinary", site, ordinary(1), seeds)};
	for (const Peer &peer : PEERS)
		rows.push_back(peer_row(peer, objective, accurate, seeds));
	return rows;
}

// The plain misfit where tipspeed's calibration ends, to show that it is the
// same objective but for its coarser scheme.
double
at_optimum(const struct site *site, const Objective &objective)
{
	struct calibrate_options o = ordinary(1);
	struct fit fit;
	Theta theta(PARAM_COUNT);
	measure_calibrate(site, &o, &fit);
	for (std::size_t j = 0; j < PARAM_COUNT; j++)
		theta[j] = fit.params.at[j];
	return objective(theta.data());
}

void
print_race(const struct site *site, unsigned seeds)
{
	struct measure_load load = measure_load();
	struct misfit *accurate = measure_misfit(site, false);
	plain::Misfit misfit(*accurate);
	Objective objective = misfit;
	std::printf("\nSpeed, %s: plain objective of %zu classes, %zu sieves, "
		    "%zu speeds, %.4e at\ntipspeed's optimum; %u seeds, one "
		    "for those of 6.4 million evaluations\n\n",
	    site->name, plain::CLASSES, misfit.n_sieve(), accurate->n_run,
	    at_optimum(site, objective), seeds);
	std::vector<Row> rows = race(site, objective, accurate, seeds);
	std::printf("%-30s%9s%9s%7s%11s%11s%9s%9s%7s%7s\n", "", "evalu-", "",
	    "mill.", "own", "accurate", "gap,best", "gap,", "times", "times");
	std::printf("%-30s%9s%9s%7s%11s%11s%9s%9s%7s%7s\n", "optimiser",
	    "ations", "seconds", "per s", "misfit", "misfit", "seed", "worst",
	    "full", "full 1");
	double best = INFINITY;
	for (const Row &row : rows)
		best = std::min(best, least(row.misfit));
	for (const Row &row : rows)
		print_row(row, best, middle(rows[0].seconds),
		    middle(rows[1].seconds));
	measure_print_others(&load);
	std::fflush(stdout);
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
	struct bounds bounds = bounds_default(0);
	struct polish *polish = polish_new(m);
	Objective accurate = [m](const double *theta) {
		struct params p = params_of(theta);
		return misfit_at(m, &p);
	};
	for (const Peer &peer : PEERS) {
		if (!peer.small)
			continue;
		double best = INFINITY;
		for (unsigned seed = 1; seed <= seeds; seed++) {
			Found f = peer.search(accurate, seed);
			struct params p = params_of(f.x.data());
			best = std::min(best, f.misfit);
			e.polished = std::min(e.polished,
			    polish_run(polish, &bounds, 1000, NULL, &p).misfit);
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
	double worst = 0;
	struct measure_load load = measure_load();
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
	measure_print_others(&load);
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
	enum { SEEDS = 3 };
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
