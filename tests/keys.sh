#!/bin/sh
# The keys of each command's JSON are those of golden/json-keys, and among them are
# those that are relied on from outside.  RENEW=1 writes the list anew.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
root=$(cd "$srcdir" && pwd)
list=$root/tests/golden/json-keys
cd "$dir" || exit 99

cat >script.tip <<'END'
version
help predict
echo one
bounds
set
seed
load data/sites/tierp.csv
sites
check
mend
show site
show feed
show product
show models
show equations
show store
show bounds
materials
materials table3/tierp
spec list
spec list limits
spec list "EN 12620 0/8"
guess speed=72
set model grunditz
params set f_mat=2.18 e0_min=16.74 alpha=0.96
params
predict 72
set model grunditz
energy load data/energy/vsi-69.csv
energy load data/energy/vsi-79.csv
energy
plot energy
calibrate
show fit
show model
show selection
show appearance
show params
params
history every=10
predict 72 interpolated=on
predict 72 cut=0/4 sharpness=6 cut_size=95
predict 72 feed=data/sites/bro.csv@69 cascade=20 k=2
predict rpm=1600 rotor_mm=900
sweep 65,74,85
sweep 69,79 cut=0/4
card speeds=69,79 tph=120
compare 69 79
compare 69 79 cut=0/4
pin speed=69
compare pinned 75
figures
flow tph=120 speed=74 recycle=8/11.2
flow tph=120 power=69:206:118,79:279:121 prices=0/2:12,2/5:9 kwh=0.15 best=on from=70 to=74
find p50=3
find "max passing 2" "P80 > 4"
find spec="EN 12620 0/8"
window "passing 2 = 30..36" "P80 > 4"
spec "ASTM C33"
why 72
why 69 79
uncertainty 74
uncertainty draws n=3
advise p80
identify
validate
blend data/sites/tierp.csv@69=60 data/sites/bro.csv@69=40 speed=72
plot psd speed=72 band=on
plot response
plot correlation
plot parity
describe psd speed=72
screen width=80 height=24
bounds f_mat 2.18
bounds e0_min 16.74
bounds alpha 0.96
validate holdout=each
league
remember trial date=2026-05-03
materials origin=own
forget trial
load data/cuts/log.csv as=log
show log
add data/cuts/tierp-may.csv
drift
load data/sites/umea.csv
params set f_mat=2.18 e0_min=16.74 alpha=0.96
compare tierp umea speed=72
params diff tierp
calibrate all population=200 generations=30
validate all
END
"$TIPSPEED" --store=:memory: --format=json -f script.tip >out.json 2>err
result $? "all commands run"
[ $bad = 0 ] || remark err

# A command that the script has no line of gives its own example.
sed -n 's/^    {\.name = "\([a-z]*\)",$/\1/p' "$root"/src/cmd/*/table_*.c >commands
[ -s commands ]
result $? "the tables have commands"
while read -r name; do
	grep -q "^$name\( \|$\)" script.tip && continue
	"$TIPSPEED" -c "help $name example" >example.tip
	"$TIPSPEED" --store=:memory: --format=json -f example.tip 2>/dev/null |
		grep "^{\"command\":\"$name\""
done <commands >>out.json

# Paths of keys, a line each, "predict params.beta"; what is in a list has its path.
grep '^{"command":' out.json | awk '{
	s = $0
	depth = n = 0
	split("", seen)
	while (s != "") {
		c = substr(s, 1, 1)
		if (c == "\"") {
			match(s, /^"([^"\\]|\\.)*"/)
			word = substr(s, 2, RLENGTH - 2)
			s = substr(s, RLENGTH + 1)
			if (s ~ /^:/) {
				key[depth] = word
				path = ""
				for (i = 1; i <= depth; i++)
					path = path (path != "" && key[i] != "" ? "." : "") key[i]
				if (!(path in seen)) {
					seen[path]
					found[n++] = path
				}
			} else if (n == 1)
				command = word
			continue
		}
		if (c ~ /[[{]/)
			key[++depth] = ""
		if (c ~ /[]}]/)
			depth--
		s = substr(s, 2)
	}
	for (i = 0; i < n; i++)
		print command, found[i]
}' | LC_ALL=C sort -u >paths

# A line a command: what the paths have is all there is.
awk '$1 != last { printf "%s%s:", last != "" ? "\n" : "", $1; last = $1 }
	{ printf " %s", $2 }
	END { print "" }' paths >keys
if [ -n "${RENEW:-}" ]; then
	cp keys "$list"
fi
awk '{ for (i = 2; i <= NF; i++) print $1, $i }' "$list" | sed 's/://' |
	LC_ALL=C sort >wanted
diff wanted paths >differences
result $? "the keys of all commands are those of the list"
remark differences

# Keys of rows are headings of columns, those with @ have a speed or size.
sed -n '/^\.Sh OUTPUT/,/^\.Sh STORE/p' "$root/man/tipspeed.1.in" >output
sed 's/.* //' paths | grep -v '^rows\.\|@' | sed 's/.*\.//' | LC_ALL=C sort -u |
	while read -r key; do
		grep -qw -- "$key" output || echo "$key"
	done >unnamed
[ ! -s unnamed ]
result $? "tipspeed(1) names each key"
remark unnamed

# fixed COMMAND KEY...: relied on from outside.
fixed() {
	command=$1
	shift
	for key; do
		grep -qxF "$command $key" paths || echo "$command $key"
	done >missing
	[ ! -s missing ]
	result $? "$command has what is relied on"
	remark missing
}
fixed predict command site speed extrapolated method sieve_mm passing_pct p20_mm \
	p50_mm p80_mm break_mm params low_pct high_pct level model_pct model trust \
	reasons provenance
fixed calibrate command site seed population generations evaluations stop misfit \
	seconds params.beta params.f_mat params.e0_min params.alpha train holdout model \
	cells parameters trust reasons
fixed validate command site holdout.speed holdout.rmse_pct \
	holdout.corrected_rmse_pct holdout.p20.measured_mm holdout.p20.predicted_mm \
	holdout.p50.measured_mm holdout.p80.predicted_mm holdout.null.feed_rmse_pct \
	holdout.null.interpolation_rmse_pct holdout.null.nearest_rmse_pct holdout.winner \
	sites p20.bias_pct p20.rms_pct p20.r2 p50.r2 p80.r2
fixed find speed_low speed_high
fixed league models.model models.holdout_rmse_pct models.aicc models.misfit can_tell
fixed window conditions inside best margin_pct binds_low binds_high certain
fixed flow feed_tph fractions.name fractions.tph fractions.share_pct \
	fractions.low_tph fractions.high_tph circulating_tph balance_tph power_kw
fixed sweep products.command products.speed products.passing_pct
fixed figures speed figures.quantity figures.value figures.unit figures.low \
	figures.high
fixed compare a.speed a.passing_pct b.speed b.passing_pct
fixed energy impacts mass_kg share_below_pct cut_j_kg per_particle k spectrum.j_kg \
	spectrum.mass_share
finish
