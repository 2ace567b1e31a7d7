#!/usr/bin/env bash
# Tests ./simbad against fakes of Java, Maven, git, apt-get and sudo: what it calls, prints and returns. Where the program
# calls the launcher back, Java and the program are real: JAVA_HOME, and the class path in SIMBAD_TEST_CLASS_PATH.
# SIMBAD_TEST_AGENT, where it is set, is an option for that Java: it measures which lines run.
# Prints a line "ok NAME" or "not ok NAME: why" for each check; exit status 1 when one is not ok.
set -u

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
# For other accounts, too.
chmod 755 "$work"
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
failures=0
real_java=${JAVA_HOME:-$(dirname "$(dirname "$(readlink -f "$(command -v javac)")")")}
real_classes=${SIMBAD_TEST_CLASS_PATH:-$here/../cli/target/classes:$here/../cli/target/lib/*}
agent=${SIMBAD_TEST_AGENT:-}
account=()

# ---------------------------------------------------------------- fakes

# A program $2 in the directory $1 with the body on standard input; each call is a line of calls.log.
fake() {
  mkdir -p "$1"
  {
    # shellcheck disable=SC2016 # for the fake to expand
    printf '#!/bin/bash\nprintf "%%s\\n" "%s $*" >>"%s/calls.log"\n' "$2" "$work"
    cat
  } >"$1/$2"
  chmod +x "$1/$2"
}

# The programs of the system that the launcher uses, and no others.
fake_system() {
  local program
  mkdir -p "$work/bin"
  for program in awk bash cat chmod cp dirname env find flock grep gzip mkdir mktemp mv readlink rm sed sha256sum sort stat \
    stty tail tee touch tr true xargs; do
    ln -s "$(type -P "$program")" "$work/bin/$program"
  done
  fake "$work/bin" id <<'END'
echo "$FAKE_UID"
END
  fake "$work/bin" git <<'END'
case " $* " in
  *' clone '*) cp -r "${@:(-2):1}" "${@: -1}" ;;
  *' status '*) printf '%s' "$FAKE_CHANGES" ;;
  *' log '*) echo 2026-01-02T03:04:05Z ;;
  *) echo "$FAKE_COMMIT" ;;
esac
END
}

# A JDK of major version $2 at $1. Its java prints its arguments and returns FAKE_STATUS; it makes the archive
# when it is asked to.
fake_jdk() {
  mkdir -p "$1/bin" "$1/lib"
  echo "JAVA_VERSION=\"$2.0.1\"" >"$1/release"
  fake "$1/bin" javac </dev/null
  fake "$1/bin" jar <<'END'
for argument; do
  [[ $argument != --file=* ]] || touch "${argument#*=}"
done
END
  fake "$1/bin" java <<'END'
for argument; do
  case $argument in
    # Nothing is missing, as far as the program itself would see.
    simbad.cli.machine.OnTheSpot) exit ;;
    -XX:DumpLoadedClassList=*) touch "${argument#*=}"; exit ;;
    -XX:SharedArchiveFile=*) [[ $* == *-Xshare:dump* ]] && { touch "${argument#*=}"; exit; } ;;
  esac
done
printf 'argument <%s>\n' "$@"
echo "directory $PWD"
exit "${FAKE_STATUS:-0}"
END
}

# A JDK at $1 that compiles and that runs the real program whichever jar it is to run.
real_jdk() {
  fake_jdk "$1" 17
  fake "$1/bin" javac <<END
exec "$real_java/bin/javac" "\$@"
END
  fake "$1/bin" java <<END
case " \$* " in
  *' -XX:DumpLoadedClassList='* | *' -Xshare:dump '*) exit 1 ;;
  *' simbad.cli.machine.OnTheSpot '*) exec "$real_java/bin/java" "\$@" ;;
esac
options=()
while [[ \$1 != -jar && \$1 != -cp ]]; do
  [[ \$1 != -Dsimbad.* && \$1 != -Djava.* ]] || options+=("\$1")
  shift
done
# The main class, where one is named.
[[ \$1 == -jar ]] || shift
# Another account cannot write what the agent measures.
agent=()
[[ -z "$agent" || \$EUID != $EUID ]] || agent=("$agent")
exec "$real_java/bin/java" "\${agent[@]}" -XX:+UseSerialGC -XX:TieredStopAtLevel=1 "\${options[@]}" -cp "$real_classes" simbad.cli.Main "\${@:3}"
END
}

# A Maven that packages; FAKE_MAVEN=fail lets it fail like a compiler error, =crash like a
# crash, =slow lets it take its time, =kill kills the program that had the launcher called.
fake_maven() {
  fake "$1" mvn <<'END'
if [[ ${FAKE_MAVEN:-} == fail ]]; then
  echo '[INFO] noise'
  echo '[ERROR] Foo.java:[3,4] cannot find symbol'
  echo '[ERROR] -> [Help 1]'
  exit 1
fi
[[ ${FAKE_MAVEN:-} == crash ]] && echo 'out of memory' && exit 1
[[ ${FAKE_MAVEN:-} == slow ]] && sleep 1
[[ ${FAKE_MAVEN:-} == kill ]] && read -r _ _ _ program _ <"/proc/$PPID/stat" && kill -KILL "$program" && exit
root=$PWD
while (($# > 0)); do
  [[ $1 == -f ]] && root=${2%/pom.xml}
  [[ $1 == -Dspark.home=* ]] && spark=${1#*=}
  shift
done
mkdir -p "$root/cli/target/lib"
[[ -z ${spark:-} ]] || { mkdir -p "$spark/jars" && cp "$FAKE_WORK/spark.jar" "$spark/cluster.jar"; }
touch "$root/cli/target/cli.jar" "$root/cli/target/lib/a.jar"
mkdir -p "$root/cli/target/licences" "$root/target/reports/apidocs"
touch "$root/cli/target"/{simbad.jar,bom.json,licences/THIRD-PARTY.txt} "$root/target/reports/apidocs/index.html"
if [[ -n ${FAKE_SKIPPED:-} ]]; then
  mkdir -p "$root/cli/target/surefire-reports"
  printf '<testcase name="%s" classname="x.YTest" time="0">\n<skipped message="no tool"/>\n</testcase>\n' \
    "$FAKE_SKIPPED" >"$root/cli/target/surefire-reports/TEST-x.xml"
fi
exit "${FAKE_STATUS:-0}"
END
}

# A new project in "$work/my project" with the launcher in it, sources of an hour ago, all tools there.
new_project() {
  rm -rf "${work:?}"/{bin,jvm,tools,tmp,"my project"}
  mkdir -m 1777 "$work/tmp"
  project="$work/my project"
  mkdir -p "$project/.mvn" "$project/cli/src/main/java/"{deep,simbad/cli} "$project/cluster/src/main" "$project"/{build-config,firmware-pic18}
  cp "$here/../simbad" "$project/simbad"
  cp "$here/packages.txt" "$project/build-config"
  cp -r "$here/../cli/src/main/java/simbad/cli/machine" "$project/cli/src/main/java/simbad/cli"
  touch "$project/cluster/src/main/java-options"
  printf '  <version>1.2</version>\n' >"$project/pom.xml"
  touch "$project"/{CHANGELOG.md,LICENSE} "$project/cli/pom.xml" "$project/cli/src/main/java/deep/"{A,B}.java
  fake_system
  fake_jdk "$work/jvm/jdk-17" 17
  fake_maven "$work/tools"
  ln -s "$(type -P sleep)" "$work/tools/sleep"
  unset FAKE_UID FAKE_COMMIT FAKE_STATUS FAKE_MAVEN FAKE_SKIPPED FAKE_CHANGES
}

# Calls the launcher with a clean environment; sets status, and output with both streams.
simbad() {
  : >"$work/calls.log"
  chmod 666 "$work/calls.log"
  output=$(cd "${from:-$work}" && "${account[@]}" env -i HOME="$work" PATH="$work/tools:$work/bin" SIMBAD_JVM_DIRECTORY="$work/jvm" \
    SIMBAD_INCLUDE_DIRECTORY="$work/include" \
    FAKE_UID="${FAKE_UID:-1000}" FAKE_COMMIT="${FAKE_COMMIT:-1234}" FAKE_STATUS="${FAKE_STATUS:-0}" \
    FAKE_MAVEN="${FAKE_MAVEN:-}" FAKE_CHANGES="${FAKE_CHANGES:-}" FAKE_SKIPPED="${FAKE_SKIPPED:-}" FAKE_WORK="$work" CI="${ci:-}" DISPLAY=:7 \
    TMPDIR="$work/tmp" SIMBAD_JAVA_OPTIONS="${temporary:+-Djava.io.tmpdir=$temporary}" SIMBAD_INSTALL="${install:-}" SIMBAD_TESTING="${testing:-}" SIMBAD_CLASS_PATH="${own_classes:-}" bash "${launcher:-$project/simbad}" "$@" </dev/null 2>&1)
  status=$?
}

# ---------------------------------------------------------------- checks

check() {
  local name=$1
  shift
  if "$@"; then
    echo "ok $name"
  else
    echo "not ok $name: $* (status $status, calls: $(tr '\n' ';' <"$work/calls.log"), output: ${output//$'\n'/ / })"
    failures=$((failures + 1))
  fi
}

status_is() { [[ $status == "$1" ]]; }
prints() { [[ $output == *"$1"* ]]; }
prints_not() { [[ $output != *"$1"* ]]; }
calls() { grep -q -- "^$1" "$work/calls.log"; }
calls_not() { ! calls "$1"; }
says_nothing() { prints_not 'simbad: '; }
builds() { [[ -e $project/cli/target/launcher/stamp ]]; }

# A jar for the place of Spark's, whose class stands before the program's own: it prints what it is started with.
fake_spark() {
  mkdir -p "$work/spark/simbad/cli"
  cat >"$work/spark/simbad/cli/SparkProcess.java" <<'END'
package simbad.cli;
public class SparkProcess {
  public static void main(String[] words) {
    System.out.println("with Spark: " + String.join(" ", words));
    System.out.println("class path: " + System.getProperty("java.class.path") + ":");
    System.out.println("option: " + System.getProperty("fake.option") + " " + System.getProperty("simbad.home"));
    System.exit(words[1].startsWith("fail") ? 42 : 0);
  }
}
END
  "$real_java/bin/javac" -d "$work/spark" "$work/spark/simbad/cli/SparkProcess.java"
  "$real_java/bin/jar" --create --file "$work/spark.jar" -C "$work/spark" simbad
  echo '-Dfake.option="as it is"' >"$project/cluster/src/main/java-options"
}

# The program says that it needs Spark; the launcher, called back, builds it.
adds_spark_where_it_is_asked_for() {
  new_project
  real_jdk "$work/jvm/jdk-17"
  fake_spark
  simbad batch spec.json --out x
  check "a batch has no Spark" prints_not 'with Spark'
  check "nor is it built" calls_not 'mvn.*cluster'
  simbad batch --spark --help
  check "help does without" calls_not 'mvn.*cluster'
  simbad batch spec.json --out x --spark
  check "wrong usage does without" prints "Missing required parameter for option '--spark'"
  (umask 077 && simbad batch spec.json --out x '--spark=local[2]' && [[ $status == 0 ]] && prints 'building for Spark')
  check "Spark is built when it is asked for" calls 'mvn.*-pl cluster'
  simbad batch spec.json --out x --spark 'local[2]'
  check "and once" calls_not mvn
  check "it is done with Spark" prints 'with Spark: batch spec.json --out x --spark local[2]'
  check "with its options for Java, and the program's" prints "option: as it is $project"
  check "its jars come first" prints "class path: $(spark_of_build)/cluster.jar:"
  check "then those of the build" prints "/cli.jar:"
  simbad batch fail.json --out x --spark 'local[2]'
  check "its exit status passes through" status_is 42
  simbad --trace blind-check --out x --spark 'local[2]'
  check "the withheld check has it as well" prints 'with Spark: --trace blind-check'
  local own_classes="$work/spark.jar"
  simbad batch spec.json --out x --spark 'local[2]'
  check "the user's classes come last" prints ":$work/spark.jar:"$'\n'
  own_classes=
  check "for all accounts" test -z "$(find "$(spark_of_build)" ! -perm -o+r)"
  read_only_with_spark
  FAKE_MAVEN=fail simbad batch spec.json --out x --spark 'local[2]'
  check "Spark that cannot be built: status 1" status_is 1
  check "Spark that cannot be built: Maven's line, and no other" test "$(wc -l <<<"$output")" = 3
  testing=1 simbad batch spec.json --out x --spark 'local[2]'
  check "nor is Spark built inside the tests" prints 'cannot build while the tests run'
}

# The program itself, which another account could not read where its classes are in somebody's home.
read_only_with_spark() {
  if ((EUID == 0)); then read_only_mount || return; else as_another_account; fi
  simbad batch spec.json --out x --spark 'local[2]'
  check "read-only: has Spark where it is built in" prints 'with Spark: '
  as_the_owner
  rm -r "$(spark_of_build)"
  if ((EUID == 0)); then read_only_mount; else as_another_account; fi
  simbad batch spec.json --out x --spark 'local[2]'
  check "read-only: no Spark where it is not" prints 'Spark is not built in'
  check "read-only: who could build it" prints "let $(id -un) type the command once"
  as_the_owner
}

spark_of_build() { echo "$project"/cli/target/launcher/build-*/spark; }

compiles_once_for_a_second() {
  new_project
  simbad table predict square
  check "a prediction does without the second compiler" prints 'argument <-XX:TieredStopAtLevel=1>'
  simbad table plot square
  check "others have it" prints_not TieredStopAtLevel
  check "others compile as Java likes" prints_not FreqInlineSize
  simbad diagnose folder
  check "a diagnosis compiles smaller pieces" prints 'argument <-XX:FreqInlineSize=60>'
  simbad diagnose --help
  check "but not its help" prints_not FreqInlineSize
}

adds_the_users_classes() {
  new_project
  mkdir -p "$work/my classes"
  touch "$work/mine.jar"
  local own_classes="mine.jar:$work/my classes"
  simbad table types
  check "the user's jar and folder follow the program" prints "/cli.jar:mine.jar:$work/my classes>"
  check "the main class is named" prints $'argument <simbad.cli.Main>\nargument <table>\nargument <types>'
  own_classes=
  simbad table types
  check "without any the jar is run" prints $'argument <-jar>\n'
}

builds_what_is_out_of_date() {
  new_project
  simbad run one 'two words' ''
  check "the first call builds" calls 'mvn -B'
  check "it says so" prints 'simbad: building'
  check "arguments arrive as they were given" prints $'argument <run>\nargument <one>\nargument <two words>\nargument <>'
  simbad run
  check "no Maven when nothing changed" calls_not mvn
  check "the archive of classes is used" prints 'classes.jsa>'
  echo change >>"$project/cli/src/main/java/deep/A.java"
  simbad run
  check "Maven after a change of a source" calls mvn
  simbad run
  check "and only once" calls_not mvn
  rm "$project/cli/src/main/java/deep/B.java"
  simbad run
  check "Maven after a deleted source" calls mvn
  : >"$project/cli/src/main/java/deep/A.java"
  touch -d '2 days ago' "$project/cli/src/main/java/deep/A.java"
  simbad run
  check "Maven after a source was put back with an old date" calls mvn
  echo change >>"$project/cli/pom.xml"
  simbad run
  check "Maven after a change of a module's pom.xml" calls mvn
  FAKE_COMMIT=5678 simbad run
  check "Maven after a commit, which the version names" calls mvn
}

keeps_builds_apart() {
  new_project
  simbad run
  local first=("$project"/cli/target/launcher/build-*)
  exec 7<"${first[0]}"
  flock -s 7
  echo change >>"$project/pom.xml"
  simbad run
  check "a build that a command still uses is kept" test -d "${first[0]}"
  exec 7<&-
  echo change >>"$project/pom.xml"
  simbad run
  check "and is deleted when it is free" test ! -e "${first[0]}"
  echo change >>"$project/pom.xml"
  : >"$work/calls.log"
  (FAKE_MAVEN=slow simbad run) & (FAKE_MAVEN=slow simbad run) & wait
  check "two launchers at once leave one build" builds_once
}

builds_once() {
  local found=("$project"/cli/target/launcher/build-??????)
  ((${#found[@]} == 1)) && simbad run && calls_not mvn
}

reports_a_failed_build() {
  new_project
  FAKE_MAVEN=fail simbad run
  check "a failed build: status 1" status_is 1
  check "a failed build: Maven's line" prints '[ERROR] Foo.java:[3,4] cannot find symbol'
  check "a failed build: nothing else of Maven's" prints_not 'Help 1'
  check "a failed build leaves no stamp" test ! -e "$project/cli/target/launcher/stamp"
  FAKE_MAVEN=crash simbad run
  check "a build that ends without an error line: all of its output" prints 'out of memory'
  simbad run
  check "the next call builds again" calls mvn
  echo change >>"$project/pom.xml"
  testing=1 simbad run
  check "no build inside the tests" prints 'cannot build while the tests run'
}

runs_from_anywhere() {
  new_project
  ln -s "$project/simbad" "$work/tools/link"
  from=/ launcher="$work/tools/link" simbad --help
  check "through a symlink: builds its own project" builds
  check "keeps the current directory" prints 'directory /'
  check "says where the data are" prints "argument <-Dsimbad.home=$project>"
  FAKE_STATUS=42 simbad run
  check "the exit status passes through" status_is 42
  check "says whom to call back" prints "argument <-Dsimbad.launcher=$project/simbad>"
}

# The option that every command has may stand before its name.
finds_the_command_behind_an_option() {
  new_project
  simbad --trace view
  check "--trace view: arrives as typed" prints $'argument <--trace>\nargument <view>'
  simbad --trace table predict square
  check "--trace table predict: without the second compiler" prints TieredStopAtLevel
  simbad bench --trace resume x
  check "bench --trace resume: is made for long" prints UseSerialGC
  simbad --help test
  check "--help test: the program's help" prints $'argument <--help>\nargument <test>'
  check "--help test: no test" calls_not 'mvn.*verify'
  simbad test --help
  check "test --help: as well" prints $'argument <test>\nargument <--help>'
  simbad doctor --help
  check "doctor --help: the program's help" prints $'argument <doctor>\nargument <--help>'
  new_project
  real_jdk "$work/jvm/jdk-17"
  simbad --trace doctor
  check "--trace doctor: is answered" prints 'ok       build'
  simbad doctor --trace
  check "doctor --trace: as well" prints 'ok       build'
  simbad --trace test --ful
  check "--trace test: reads its options" prints "test: '--ful' is not an option"
}

# Makes the next calls those of an account that may read the project and not write to it.
as_another_account() {
  if ((EUID == 0)); then
    account=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  else
    chmod -R a-w "$project"
  fi
}

as_the_owner() {
  account=()
  chmod -R u+w "$project"
}

# A git clone with the real git, which refuses to look at other accounts' clones.
new_clone() {
  new_project
  ln -sf "$(type -P git)" "$work/tools/git"
  echo /cli/target >"$project/.gitignore"
  git -C "$project" init -q
  git -C "$project" add -A
  git -C "$project" -c user.name=x -c user.email=x@example.org commit -qm x
}

runs_for_another_account() {
  local launcher project
  new_clone
  as_another_account
  simbad run
  check "another account, not built: status 1" status_is 1
  check "another account, not built: one line" test "$(wc -l <<<"$output")" = 1
  check "another account, not built: whose it is" prints "is not built, and this account may not write there; let $(id -un) call"
  as_the_owner
  (umask 077 && simbad run)
  as_another_account
  simbad run
  check "another account: runs what its owner built" status_is 0
  check "another account: without a word" says_nothing
  check "another account: without Maven" calls_not mvn
  simbad test
  check "another account: cannot test there" prints 'test: builds in'
  as_the_owner
  echo change >>"$project/cli/src/main/java/deep/A.java"
  as_another_account
  simbad run
  check "another account: runs an older build" status_is 0
  check "another account: and says so" prints 'the sources are not those of the build, which this account may not renew'
  as_the_owner
  runs_from_a_worktree
}

runs_from_a_worktree() {
  git -C "$project" worktree add -q "$work/tree" 2>/dev/null
  project=$work/tree launcher=$work/tree/simbad
  simbad run
  as_another_account
  simbad run
  check "another account: a worktree as well" says_nothing
  as_the_owner
  rm -rf "$work/tree"
}

# A copy, or an image of a container, has the same files with other dates.
runs_a_copy_as_built() {
  local launcher project
  new_clone
  simbad run
  cp -a "$project" "$work/copy"
  project=$work/copy launcher=$work/copy/simbad
  rm -rf "$project/.git"
  as_another_account
  simbad run
  check "a copy that cannot be written: runs" status_is 0
  check "a copy that cannot be written: as built" says_nothing
  as_the_owner
  simbad run
  check "a copy: no build" calls_not mvn
  check "a copy: is looked at closely once" test -z "$(find "$project" -path '*/src/*' -newercm "$project/cli/target/launcher/stamp")"
  rm -rf "$work/copy"
}

# Makes the project read-only in the next calls; false where this account may mount nothing.
read_only_mount() {
  unshare -m true 2>/dev/null || return
  # shellcheck disable=SC2016 # for the other shell to expand
  account=(unshare -m bash -c 'mount --bind -o ro "$0" "$0" && "$@"' "$project")
}

runs_from_a_read_only_mount() {
  new_clone
  simbad run
  read_only_mount || return
  from=/ simbad run
  check "read-only: runs from any folder" status_is 0
  check "read-only: without a word" says_nothing
  account=()
}

chooses_a_new_enough_java() {
  new_project
  fake_jdk "$work/jvm/a-jdk-11" 11
  simbad run
  check "an old JDK is passed over" status_is 0
  check "an old JDK is not asked" calls 'java '
  rm -r "$work/jvm/jdk-17"
  simbad run
  check "only an old JDK: says what to install" prints 'jdk-headless'
}

# An apt-get that installs, and package lists that have Java 21 only.
fake_apt() {
  fake "$work/tools" apt-cache <<'END'
[[ $2 == openjdk-21-* ]]
END
  fake "$work/tools" apt-get <<'END'
[[ " $* " == *" install "* ]] || { echo 'Get:1 lists'; exit; }
cp -r "$FAKE_WORK/store/." "$FAKE_WORK"
END
}

installs_with_apt() {
  new_project
  rm -rf "$work/store"
  mkdir -p "$work/store/tools"
  mv "$work/jvm" "$work/store/jvm"
  mv "$work/tools/mvn" "$work/store/tools/mvn"
  fake_apt
  simbad run
  check "no root, no sudo: status 1" status_is 1
  check "no root, no sudo: the line to type" prints \
    'sudo apt-get update && sudo apt-get install -y --no-install-recommends openjdk-21-jdk-headless maven libfontconfig1 libfreetype6 fonts-dejavu-core'
  check "no root, no sudo: nothing installed" calls_not apt-get
  fake "$work/tools" sudo <<<'exit 1'
  simbad run
  check "sudo that would ask for a password: the line to type" prints 'please type: sudo apt-get'
  check "sudo is not left waiting" calls 'sudo -n true'
  fake "$work/tools" sudo <<'END'
shift
exec "$@"
END
  simbad run
  check "sudo: installs" calls \
    'apt-get .*install -y --no-install-recommends openjdk-21-jdk-headless maven libfontconfig1 libfreetype6 fonts-dejavu-core'
  check "sudo: what and why is said" prints \
    'installing with apt to build the program: openjdk-21-jdk-headless maven libfontconfig1 libfreetype6 fonts-dejavu-core (with SIMBAD_INSTALL=no'
  check "sudo: then runs" status_is 0
  rm -r "$work/jvm" "$work/tools/mvn" "$work/tools/sudo"
  FAKE_UID=0 simbad run
  check "root: installs without sudo" calls 'apt-get .*install'
  check "root: then runs" status_is 0
  simbad run
  check "all there: no apt-get" calls_not apt-get
  rm -r "$work/jvm" "$work/tools/mvn"
  echo change >>"$project/pom.xml"
  install=no FAKE_UID=0 simbad run
  check "told not to: status 1" status_is 1
  check "told not to: the line to type, of root" prints \
    'missing here to build the program; please type: apt-get update && apt-get install -y --no-install-recommends openjdk-21-jdk-headless maven libfontconfig1 libfreetype6 fonts-dejavu-core'
  check "told not to: nothing is installed" calls_not apt-get
}

# As simbad does, at a terminal: output has what a person would see, the bytes that wipe a line included.
simbad_at_a_terminal() {
  local line
  : >"$work/calls.log"
  printf -v line '%q ' env SIMBAD_TESTING= SIMBAD_INSTALL= PATH="$work/tools:$work/bin" SIMBAD_JVM_DIRECTORY="$work/jvm" HOME="$work" FAKE_UID=0 FAKE_COMMIT=1 \
    FAKE_WORK="$work" FAKE_MAVEN="${FAKE_MAVEN:-}" bash "$project/simbad" "$@"
  output=$(script -qec "$line" /dev/null </dev/null)
  status=$?
}

shows_progress_on_a_terminal() {
  new_project
  FAKE_MAVEN=fail simbad_at_a_terminal run
  check "terminal: what Maven says is seen" prints $'\r\e[Knoise'
  check "terminal: and wiped" prints $'\r\e[K[ERROR] Foo.java:[3,4] cannot find symbol'
  check "terminal: Maven says what it fetches" calls_not 'mvn .*-ntp'
  check "terminal: Maven's status counts" status_is 1
  fake_apt
  real_jdk "$work/jvm/jdk-17"
  rm "$work/tools/mvn"
  simbad_at_a_terminal run
  check "terminal: what is installed is said before, the progress seen" prints \
    $'installing with apt to build the program: maven (with SIMBAD_INSTALL=no it says what to type instead)\r\n\r\e[KGet:1 lists'
}

tests_like_ci() {
  new_project
  real_jdk "$work/jvm/jdk-17"
  mkdir -p "$work/include/gpsim"
  touch "$work/include/cmocka.h" "$work/include/gpsim/modules.h"
  for tool in Xvfb xauth shellcheck chromium cppcheck git-secrets gpsim g++ make gcc clang avr-gcc simavr python3; do fake "$work/tools" "$tool" </dev/null; done
  simbad test -- -pl sonar-model
  check "test: verify, with what follows --" calls 'mvn -B -ntp verify -T 2 .*-pl sonar-model'
  simbad test --full
  check "test --full: the long campaigns" calls 'mvn -B -ntp verify -T 2 .*-Dsimbad.full=true'
  check "test: the program is not packaged before" calls_not 'mvn.* package'
  simbad test --ful
  check "test: an unknown option is wrong usage" status_is 2
  FAKE_STATUS=1 simbad test
  check "test: Maven's status passes through" status_is 1
  FAKE_SKIPPED=hears simbad test
  check "test: a skipped test passes elsewhere" status_is 0
  ci=true FAKE_SKIPPED=hears simbad test
  check "test: a skipped test fails in CI" status_is 1
  check "test: and is named" prints 'x.YTest.hears'
}

tells_what_works() {
  new_project
  real_jdk "$work/jvm/jdk-17"
  fake "$work/tools" apt-get </dev/null
  simbad doctor
  check "doctor: a JDK and Maven build" prints 'ok       build'
  check "doctor: and that is a success" status_is 0
  check "doctor: says what the board needs" prints 'gpsim'
  check "doctor: builds nothing" calls_not mvn
  check "doctor: installs nothing" calls_not apt-get
  check "doctor: leaves nothing behind" test -z "$(ls "$work/tmp")"
  simbad run --help
  simbad doctor
  check "doctor: the same of the program that is built" prints 'ok       build'
  check "doctor: which says what the board needs, too" prints 'gpsim'
  rm -r "$work/jvm/jdk-17/bin/javac" "$project/cli/src/main/java/deep"
  simbad doctor
  check "doctor: without a compiler an old build is asked" calls 'java .*cli.jar doctor'
  check "doctor: and not renewed" calls_not mvn
  rm -r "${work:?}/jvm" "$work/tools/mvn"
  simbad doctor
  check "doctor: without Java it still answers" prints 'missing here to build the program'
  check "doctor: names what to install" prints 'maven'
  check "doctor: nothing can be built, status 1" status_is 1
}

releases_a_commit() {
  new_project
  real_jdk "$work/jvm/jdk-17"
  from=$work simbad release --out "my release/"
  check "release: is done" status_is 0
  check "release: is of the commit, built in a clone" calls 'git clone'
  check "release: dates are the commit's" calls 'mvn .*outputTimestamp=2026-01-02T03:04:05Z'
  output=$(cd "$work/my release" && echo *)
  check "release: has all of it" prints "CHANGELOG.md LICENSE SHA256SUMS THIRD-PARTY.txt simbad-sonar-1.2-javadoc.jar \
simbad-sonar-1.2-sources.tar.gz simbad-sonar-1.2.cdx.json simbad-sonar-1.2.jar"
  check "release: the sums are right" sums_are_right
  FAKE_CHANGES=$' M a\n?? b\n' simbad release --out changed
  check "release: says what differs from the commit" prints 'made from the commit 1234, without the 2 files that differ'
  simbad release --out changed
  check "release: nothing is overwritten: status 2" status_is 2
  simbad release --jar-only --out jar
  check "release --jar-only: is done" status_is 0
  check "release --jar-only: has the jar and nothing else" test "$(ls "$work/jar")" = simbad.jar
  check "release --jar-only: of what is compiled already" calls_not 'git .*clone'
  check "release --jar-only: without checks, SBOM and Javadoc" calls_not 'mvn.*makeBom'
  FAKE_CHANGES=$' M a\n' simbad release --jar-only --out jar2
  check "release --jar-only: of the commit where a file differs" calls 'git .*clone'
  check "release --jar-only: and says so" prints 'made from the commit 1234, without the 1 file that differs'
  FAKE_MAVEN=fail simbad release --out failed
  check "release: a failed build: status 1" status_is 1
  check "release: a failed build: Maven's line" prints '[ERROR] Foo.java:[3,4] cannot find symbol'
  output=$(cd "$work" && echo failed .*unfinished*)
  check "release: a failed build leaves nothing" prints 'failed .*unfinished*'
  check "release: a failed build publishes nothing" test ! -e "$work/failed"
}

# What a killed one left: of a process that is gone, of one that runs, of another that has the number now.
sweeps_after_a_kill() {
  local mark temporary=$work/temporary sleeper start
  new_project
  real_jdk "$work/jvm/jdk-17"
  simbad release --help
  mkdir "$temporary"
  FAKE_MAVEN="kill" simbad release --out killed
  mark=$(cd "$work" && echo .killed.unfinished-*-1)
  mark=${mark#.killed.unfinished-}
  check "release: killed, it leaves its work" test -d "$temporary/simbad-release-${mark%-1}-2"
  check "release: and what it had begun" test -d "$work/.killed.unfinished-$mark"
  sleep 100 &
  sleeper=$!
  start=$(cut -d ' ' -f 22 "/proc/$sleeper/stat")
  mkdir "$work/.runs.unfinished-$sleeper-$start-${mark#*-*-}" "$work/.reused.unfinished-$sleeper-1$start-${mark#*-*-}" \
    "$work/.far.unfinished-$sleeper-1$start-000000-000000-1"
  simbad release --out killed
  check "release: the next one is done" status_is 0
  output=$(cd "$work" && echo .*.unfinished* "$temporary"/*)
  check "release: and sweeps what no process needs, on this machine" prints \
    ".far.unfinished-$sleeper-1$start-000000-000000-1 .runs.unfinished-$sleeper-$start-${mark#*-*-} $temporary/*"
  kill "$sleeper"
  rm -r "$work"/.*.unfinished*
}

sums_are_right() { (cd "$work/my release" && sha256sum --quiet -c SHA256SUMS); }

refuses_a_bad_release() {
  new_project
  real_jdk "$work/jvm/jdk-17"
  simbad --trace release
  check "release: without --out: status 2" status_is 2
  check "release: without --out: says so" prints "Missing required option: '--out=DIR'"
  simbad release --out
  check "release: --out without a folder: status 2" status_is 2
  simbad release --out x y
  check "release: an unknown word: status 2" status_is 2
  simbad release --out "$project/pom.xml/x"
  check "release: below a file: status 2" status_is 2
  simbad release --out "$project"
  check "release: a folder that is not empty: status 2" status_is 2
  FAKE_COMMIT=
  mv "$work/bin/git" "$work/bin/no-git"
  fake "$work/bin" git <<<'exit 128'
  simbad release --out x
  check "release: of no clone: status 1" status_is 1
  check "release: of no clone: says so" prints 'is not a git clone; a release is made from a commit'
}

check_style() {
  output=$(shellcheck "$here/../simbad" "$here/../.ci/run" "$here/../benchmarks/"{whole-process,memory} "$here/../docs/figures/measure" "$here/dockerfile-test" "$here/../python/"{build,check} \
    "${BASH_SOURCE[0]}")
  status=$?
  check "shellcheck finds nothing" status_is 0
}

adds_spark_where_it_is_asked_for
adds_the_users_classes
compiles_once_for_a_second
builds_what_is_out_of_date
keeps_builds_apart
reports_a_failed_build
runs_from_anywhere
chooses_a_new_enough_java
finds_the_command_behind_an_option
runs_for_another_account
runs_a_copy_as_built
runs_from_a_read_only_mount
installs_with_apt
shows_progress_on_a_terminal
tests_like_ci
tells_what_works
releases_a_commit
sweeps_after_a_kill
refuses_a_bad_release
check_style
((failures == 0))
