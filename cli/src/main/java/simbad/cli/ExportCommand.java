package simbad.cli;

import picocli.CommandLine.Command;

/** {@code simbad export}: what was measured, for other programs. */
@Command(
    name = "export",
    description =
        "Write what was measured in a form for other programs: source code, or a recording.",
    subcommands = {ExportC99Command.class, ExportBagCommand.class},
    footer = {"", "Example: simbad export c99 angle --out angle.h"})
final class ExportCommand extends CommandGroup {}
