#!/bin/sh
# Many sites at once: threads and parts change no byte, and what `collect`
# refuses.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
unset SLURM_ARRAY_TASK_ID SLURM_ARRAY_TASK_COUNT SLURM_ARRAY_TASK_MIN \
	SLURM_ARRAY_TASK_STEP OMPI_COMM_WORLD_RANK OMPI_COMM_WORLD_SIZE

# A few sites, but more than there are parts below.
head -n 8 data/table3.csv >table.csv
search="population=$(often 100 400) generations=$(often 8 25)"

# run OPTIONS FILE [SEED]: calibrates the sites, or a part.
run() {
	"$TIPSPEED" -c "synth table.csv seed=${3:-1}" \
		-c "calibrate all $search $1 > $2" \
		>>log 2>&1
}

# collected FILE...: joins them as each form of one run.
collected() {
	for form in csv json md; do
		"$TIPSPEED" -c "collect $* > all.$form" >>log 2>&1 &&
			cmp one.$form all.$form || return 1
	done
}

# refuses WORDS FILE...: with exit status 3.
refuses() {
	words=$1
	shift
	"$TIPSPEED" -c "collect $*" >out 2>refusal
	[ $? -eq 3 ] && [ ! -s out ] && grep -q "$words" refusal
}

for form in csv json md; do
	run threads=1 one.$form
done
run threads=3 three.json
cmp one.json three.json
result $? 'the same with one thread and three'

for i in 1 2 3; do
	run part=$i/3 p$i.json
done
collected p2.json p3.json p1.json
result $? 'three parts, in any order, are one run'
cat p3.json p1.json >some.json
collected some.json p2.json
result $? 'so are several parts in one file'

for i in 5 7 9; do
	SLURM_ARRAY_TASK_ID=$i SLURM_ARRAY_TASK_COUNT=3 \
		SLURM_ARRAY_TASK_MIN=5 SLURM_ARRAY_TASK_STEP=2 \
		OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=1 run '' s$i.json
done
collected s5.json s7.json s9.json
result $? "a job array's variables say which part"
for i in 0 1; do
	OMPI_COMM_WORLD_RANK=$i OMPI_COMM_WORLD_SIZE=2 run '' m$i.json
done
collected m0.json m1.json
result $? "so do mpirun's"
OMPI_COMM_WORLD_RANK=1 OMPI_COMM_WORLD_SIZE=2 run part=1/3 again.json
cmp p1.json again.json
result $? 'part= comes before them'
for i in $(seq 9); do
	run part=$i/9 more$i.json
done
collected more*.json
result $? 'there may be more parts than sites'

# One that is killed leaves nothing behind, and is run again alone.
rm p2.json
"$TIPSPEED" -c 'synth table.csv' -c \
	'calibrate all population=100000 tolerance=0 stall=0 part=2/3 > p2.json' \
	>>log 2>&1 &
task=$!
sleep 0.5
kill -9 $task
wait $task 2>>log
[ ! -e p2.json ] && refuses 'part 2 of 3 is missing' p1.json p3.json
result $? 'a part whose task was killed is missed by its number'
run part=2/3 p2.json && collected p1.json p2.json p3.json
result $? 'and is made again alone'

refuses 'part 1 of 3 is already in p1.json' p1.json p2.json p3.json again.json
result $? 'a part that is there twice is refused'
run part=2/4 four.json
refuses 'expected a part of 3, as p1.json is, got one of 4' p1.json four.json
result $? 'one of other parts is refused'
run 'part=2/3 stall=7' other.json
refuses 'expected the options of p1.json' p1.json other.json p3.json
result $? 'one with other options is refused'
run part=2/3 other.json 2
refuses 'expected the sites of p1.json' p1.json other.json p3.json
result $? 'one of other sites is refused'
sed 's/"version":"[^"]*"/"version":"0.0.9"/' p2.json >other.json
refuses 'expected the version of p1.json .*, got 0.0.9' \
	p1.json other.json p3.json
result $? 'one of another version is refused'
sed 's/"format":1/"format":2/' p2.json >other.json
refuses 'other.json: tipspeed .* wrote this part in format 2, but this build' \
	p1.json other.json p3.json
result $? 'one of a build with another format is refused'
for i in 1 2 3; do
	sed 's/"format":1,//' p$i.json >old$i.json
done
refuses 'old1.json: tipspeed .* wrote this part in format 0, but this build' \
	old1.json old2.json old3.json
result $? 'and those from before there was a format'
head -c 300 p2.json >short.json
refuses "expected what 'calibrate all part=I/N' or" p1.json short.json &&
	refuses "expected what 'calibrate all part=I/N' or" one.json
result $? 'half a part is refused, and what is none'

# Collision energies are options, too, also of a part without a site.
"$TIPSPEED" -c 'synth table.csv' -c 'set energy data/energy/vsi-69.csv' -c \
	"calibrate all $search part=9/9 > other.json" \
	>>log 2>&1
refuses 'expected the options of more1.json' more1.json other.json
result $? 'one with other collision energies is refused'

# both OPTIONS FILE [FIRST]: calibrates and validates sites, or a part of them.
# Three threads hold each speed out in the long tests only, at sites with a few of
# their sieves.
both() {
	"$TIPSPEED" --store="$2.db" -c 'synth table.csv' -c "${3:-version}" \
		-c "calibrate all $search $1 > $2.json" \
		-c 'remember all' -c "validate all $1 > v$2.json" >>log 2>&1
	if [ "$2" = three ] && [ "$(often 0 1)" -eq 0 ]; then
		return
	fi
	"$TIPSPEED" tierp.csv bro.csv -c "${3:-version}" \
		-c "validate all holdout=each $1 > e$2.json" >>log 2>&1
}

for site in tierp bro; do
	awk 'NR <= 6 || NR % 3 == 1' data/sites/$site.csv >$site.csv
done
both '' whole 'set threads 1'
both '' three 'set threads 3'
cmp vwhole.json vthree.json &&
	{ [ ! -e ethree.json ] || cmp ewhole.json ethree.json; }
result $? 'validate all is the same with one thread and three'
for i in 1 2 3; do
	both part=$i/3 part$i
done
for k in v e; do
	"$TIPSPEED" -c "collect ${k}part2.json ${k}part1.json ${k}part3.json \
		> all.json" >>log 2>&1
	cmp ${k}whole.json all.json
	result $? "parts of validate all are one run, too ($k)"
done
refuses 'expected the command of vpart1.json (validate), got calibrate' \
	vpart1.json part2.json vpart3.json
result $? 'parts of two commands are refused'
refuses 'expected the options of vpart1.json' \
	vpart1.json epart2.json vpart3.json
result $? 'so are those of speeds held out in another way'

parts='part1.json part2.json part3.json'
"$TIPSPEED" --store=joined.db \
	-c "collect $parts part3.db part1.db part2.db > all.json" \
	>>log 2>&1 && cmp whole.json all.json && cmp whole.db joined.db
result $? "the parts' stores are the store of one run"
refuses 'but is in none of the stores' $parts part1.db part2.db
result $? 'a store that is missing is missed'
cp part1.db again.db
refuses 'is already in part1.db\|is already in again.db' \
	$parts part1.db part2.db part3.db again.db
result $? 'a material that is there twice is refused'
"$TIPSPEED" --store=other.db -c 'synth table.csv' -c \
	'calibrate all train=all part=2/3 > /dev/null' \
	-c 'remember all' >>log 2>&1
refuses 'got another (misfit' $parts part1.db other.db part3.db
result $? 'one of another calibration is refused'
"$TIPSPEED" --store=part2.db -c 'load data/sites/tierp.csv' \
	-c 'params set f_mat=2 e0_min=17 alpha=0.95' -c 'remember more' \
	>>log 2>&1
refuses 'belongs to none of the parts' $parts part1.db part2.db part3.db
result $? 'one of no part is refused'
refuses 'expected the parts that this store belongs to' part1.db
result $? 'a store goes with its parts'

# What cannot be compared is listed at the end, and the answer stays.
"$TIPSPEED" -c 'load data/sites/tierp.csv data/sites/bro.csv' \
	-c 'calibrate population=400' -c 'use tierp' -c 'set model vogel' \
	-c 'calibrate population=400' -c 'set model grunditz' \
	-c 'set method classes' -c 'set appearance progeny_mm' \
	-c 'validate all > some.csv' \
	>>log 2>refusal
[ $? -eq 2 ] && [ "$(grep -c P20,model some.csv)" -eq 1 ] &&
	grep -q '1 of 2 calibrated sites could not be compared (tierp)' refusal
result $? 'a site that cannot be compared is told, the others are'

# Of many files those that can be read are loaded.
mkdir sheets && cp data/sites/bro.csv data/sites/tierp.csv sheets
printf 'size_mm,feed,product@70\n4,abc,100\n' >sheets/cut.csv
echo 'no sheet' >sheets/notes.md
"$TIPSPEED" -c 'load sheets' -c 'echo on' >out 2>refusal
[ $? -eq 3 ] && [ ! -s out ] &&
	grep -q '2 of 3 files are loaded, not these' refusal &&
	grep -q "cut.csv:2:3: expected a number, got 'abc'" refusal
result $? 'of a folder the good are loaded, and a script ends with the code'
"$TIPSPEED" -c 'load sheets skip=on' -c 'sites > names.csv' 2>refusal &&
	[ "$(wc -l <names.csv)" -eq 3 ] && grep -q "got 'abc'" refusal
result $? 'with skip=on it goes on'
mkdir none
"$TIPSPEED" -c 'load none' 2>refusal
[ $? -eq 3 ] && grep -q 'expected sheets in this folder' refusal
result $? 'a folder without sheets is refused'
ln data/sites/bro.csv other-name.csv 2>>log || cp sheets/bro.csv other-name.csv
ln -s other-name.csv third-name.csv
"$TIPSPEED" -c 'load other-name.csv' -c 'load third-name.csv' \
	-c 'sites > names.csv' 2>refusal && [ "$(wc -l <names.csv)" -eq 2 ] &&
	grep -q 'replaced bro, loaded earlier' refusal
result $? 'a file by another name is known'

"$TIPSPEED" -c 'synth table.csv' -c 'calibrate all part=4/3' \
	2>refusal
[ $? -eq 2 ] && grep -q 'got 4/3' refusal
result $? 'part 4 of 3 is refused'

# unready STATUS WORDS SITES OPTIONS: validate all of sites without parameters.
printf 'site,Feed only\nsize_mm,feed\n8,100\n4,60\n2,20\n' >feed.csv
unready() {
	"$TIPSPEED" -c "load $3" -c "validate all $4" >out 2>refusal
	[ $? -eq "$1" ] && { [ "$1" -eq 0 ] || [ ! -s out ]; } &&
		grep -q "$2" refusal
}
one=data/sites/tierp.csv
unready 2 'no site of part 1/3 has both a calibration' $one part=1/3 &&
	grep -q "run 'calibrate all part=1/3'" refusal
result $? 'a part that was not calibrated is refused'
unready 0 '' $one part=2/3 && unready 0 '' "feed.csv $one" part=1/2
result $? 'one without a site to calibrate is a part'
unready 2 'no site of part 1/2' feed.csv part=1/2 &&
	unready 3 'products at three or more speeds' feed.csv \
		'part=1/2 holdout=each'
result $? 'but not where no site could be'
unready 0 '' $one 'part=2/3 holdout=each' &&
	unready 0 '' "feed.csv $one" 'part=1/2 holdout=each'
result $? 'nor with holdout=each'
[ "$bad" -eq 0 ] || remark log
finish
