package simbad.bench.link;

class MemoryLinkTest extends SerialLinkContract {
  @Override
  Ends open() {
    MemoryLink.Pair pair = MemoryLink.pair();
    return new Ends(pair.here(), pair.there());
  }
}
