// Uses the installed engine: default settings are valid, and say so.
#include <aips/adapter/settings.h>

#include <iostream>

int main() {
    const aips::Settings settings;
    aips::validate(settings);
    std::cout << aips::describe(settings) << '\n';
}
