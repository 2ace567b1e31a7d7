package simbad.cli;

import picocli.CommandLine.Command;

/** {@code simbad export}: what was measured, for other programs. */
@Command(
    name = "export",
    description = "Write what was measured as source code for other programs.",
    subcommands = {ExportC99Command.class},
    footer = {"", "Example: simbad export c99 angle --out angle.h"})
final class ExportCommand extends CommandGroup {}
