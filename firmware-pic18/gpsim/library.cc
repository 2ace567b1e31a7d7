// What gpsim asks of a module library: which modules there are. The third, "driver", is the line to a program.
#include "driver.h"
#include "pty_uart.h"
#include "srf04.h"

namespace {

class DriverModule : public Module {
public:
    explicit DriverModule(const char *name) : Module(name, "line to a program that decides what the board meets")
    {
        create_pkg(0);
        addSymbol(new board::TextAttribute("socket", "path of the program's socket",
                                           [](const char *path) { board::driver.connect(path); }));
    }

    static Module *construct(const char *name) { return new DriverModule(name ? name : "driver"); }
};

Module_Types types[] = {{{"srf04", "srf04"}, board::Srf04::construct},
                        {{"ptyuart", "ptyuart"}, board::PtyUart::construct},
                        {{"driver", "driver"}, DriverModule::construct},
                        {{nullptr, nullptr}, nullptr}};

} // namespace

extern "C" Module_Types *get_mod_list()
{
    return types;
}
