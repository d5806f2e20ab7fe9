<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Engine</name>
    <message>
        <source>Drawing the map was cancelled, it is not written</source>
        <translation>Das Zeichnen der Karte wurde abgebrochen, sie ist nicht geschrieben</translation>
    </message>
    <message>
        <source>anchor %1</source>
        <translation>Anker %1</translation>
    </message>
    <message>
        <source>projector</source>
        <translation>Projektor</translation>
    </message>
    <message>
        <source>its number is used twice</source>
        <translation>seine Nummer ist doppelt vergeben</translation>
    </message>
    <message>
        <source>its coordinates are not finite numbers</source>
        <translation>seine Koordinaten sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>its point lies %1 outside the blueprint; correct or disable it</source>
        <translation>sein Punkt liegt %1 außerhalb des Bauplans; korrigieren oder abschalten</translation>
    </message>
    <message>
        <source>its point lies %1 outside the SLAM map; correct or disable it</source>
        <translation>sein Punkt liegt %1 außerhalb der SLAM-Karte; korrigieren oder abschalten</translation>
    </message>
    <message>
        <source>anchors %1 and %2 share a blueprint point but are %3 apart in the SLAM map; correct or disable one of them</source>
        <translation>Anker %1 und %2 haben denselben Punkt im Bauplan, liegen aber in der SLAM-Karte %3 auseinander; einen davon korrigieren oder abschalten</translation>
    </message>
    <message>
        <source>anchors %1 and %2 share a SLAM map point but are %3 apart in the blueprint; correct or disable one of them</source>
        <translation>Anker %1 und %2 haben denselben Punkt in der SLAM-Karte, liegen aber im Bauplan %3 auseinander; einen davon korrigieren oder abschalten</translation>
    </message>
    <message>
        <source>no pair of corresponding points to align with</source>
        <translation>kein Paar zusammengehöriger Punkte zum Ausrichten</translation>
    </message>
    <message>
        <source>a pair of corresponding points is not finite</source>
        <translation>ein Paar zusammengehöriger Punkte ist nicht endlich</translation>
    </message>
    <message>
        <source>all points are at one place, so rotation and scale are unknown</source>
        <translation>alle Punkte liegen an einer Stelle, also sind Drehung und Maßstab unbekannt</translation>
    </message>
    <message>
        <source>the points do not determine a rotation and a scale</source>
        <translation>die Punkte legen Drehung und Maßstab nicht fest</translation>
    </message>
    <message>
        <source>the resolution of a map must be a positive number of metres per pixel</source>
        <translation>die Auflösung einer Karte muss eine positive Zahl von Metern je Pixel sein</translation>
    </message>
    <message>
        <source>a map must be at least one pixel wide and high</source>
        <translation>eine Karte muss mindestens ein Pixel breit und hoch sein</translation>
    </message>
    <message>
        <source>the origin of a map must be three finite numbers</source>
        <translation>der Ursprung einer Karte muss aus drei endlichen Zahlen bestehen</translation>
    </message>
    <message>
        <source>the cell size must be a positive number of metres</source>
        <translation>die Zellgröße muss eine positive Zahl von Metern sein</translation>
    </message>
    <message>
        <source>cells of %1 m give a mesh of more than %2 nodes; choose a larger cell size</source>
        <translation>Zellen von %1 m ergeben ein Netz von mehr als %2 Knoten; eine größere Zellgröße wählen</translation>
    </message>
    <message>
        <source>the blueprint has no free pixel, so there is nothing to mesh</source>
        <translation>der Bauplan hat kein freies Pixel, also gibt es nichts zu vernetzen</translation>
    </message>
    <message>
        <source>the mesh needs a finite, positive cell size and a finite origin</source>
        <translation>das Netz braucht eine endliche, positive Zellgröße und einen endlichen Ursprung</translation>
    </message>
    <message>
        <source>the mesh has no node</source>
        <translation>das Netz hat keinen Knoten</translation>
    </message>
    <message>
        <source>the mesh has %1 centres for %2 tiles</source>
        <translation>das Netz hat %1 Mittelpunkte für %2 Kacheln</translation>
    </message>
    <message>
        <source>the mesh has a node at no finite place</source>
        <translation>das Netz hat einen Knoten an keiner endlichen Stelle</translation>
    </message>
    <message>
        <source>the mesh has two nodes on one tile</source>
        <translation>das Netz hat zwei Knoten auf einer Kachel</translation>
    </message>
    <message>
        <source>there is no enabled anchor; at least one pair of corresponding points is needed</source>
        <translation>kein Anker ist eingeschaltet; mindestens ein Paar zusammengehöriger Punkte wird gebraucht</translation>
    </message>
    <message>
        <source>the scale must be a positive number</source>
        <translation>der Maßstab muss eine positive Zahl sein</translation>
    </message>
    <message>
        <source>the mesh of %1 nodes is too large for the memory of this computer; choose a larger cell size</source>
        <translation>das Netz von %1 Knoten ist zu groß für den Speicher dieses Rechners; eine größere Zellgröße wählen</translation>
    </message>
    <message>
        <source>the optimisation was cancelled</source>
        <translation>die Optimierung wurde abgebrochen</translation>
    </message>
    <message>
        <source>the optimisation found no finite minimum; check the anchors and the weights</source>
        <translation>die Optimierung fand kein endliches Minimum; Anker und Gewichte prüfen</translation>
    </message>
    <message>
        <source>the anchors do not determine the mesh; add anchors or enable some</source>
        <translation>die Anker legen das Netz nicht fest; Anker hinzufügen oder einschalten</translation>
    </message>
    <message>
        <source>One place is anchored: only the translation is known; add an anchor far away from it.</source>
        <translation>Eine Stelle ist verankert: nur die Verschiebung ist bekannt; einen Anker weit weg davon setzen.</translation>
    </message>
    <message>
        <source>Two places are anchored: only rotation and translation are known; a third anchor lets the mesh bend.</source>
        <translation>Zwei Stellen sind verankert: nur Drehung und Verschiebung sind bekannt; mit einem dritten Anker kann sich das Netz biegen.</translation>
    </message>
    <message>
        <source>The optimisation stopped after %1 iterations before it had converged.</source>
        <translation>Die Optimierung hielt nach %1 Iterationen an, bevor sie konvergiert war.</translation>
    </message>
    <message>
        <source>The planner needs a positive step, and a radius, clearance and clearance cost that are not negative</source>
        <translation>Der Planer braucht einen positiven Schritt und einen Radius, einen Abstand und Abstandskosten, die nicht negativ sind</translation>
    </message>
    <message>
        <source>The start %1 lies outside of the map</source>
        <translation>Der Start %1 liegt außerhalb der Karte</translation>
    </message>
    <message>
        <source>The goal %1 lies outside of the map</source>
        <translation>Das Ziel %1 liegt außerhalb der Karte</translation>
    </message>
    <message>
        <source>The start %1 lies inside a wall</source>
        <translation>Der Start %1 liegt in einer Wand</translation>
    </message>
    <message>
        <source>The goal %1 lies inside a wall</source>
        <translation>Das Ziel %1 liegt in einer Wand</translation>
    </message>
    <message>
        <source>The start %1 lies where the map is unknown</source>
        <translation>Der Start %1 liegt, wo die Karte unbekannt ist</translation>
    </message>
    <message>
        <source>The goal %1 lies where the map is unknown</source>
        <translation>Das Ziel %1 liegt, wo die Karte unbekannt ist</translation>
    </message>
    <message>
        <source>The start %1 lies nearer to a wall than the radius of the robot</source>
        <translation>Der Start %1 liegt näher an einer Wand als der Radius des Roboters</translation>
    </message>
    <message>
        <source>The goal %1 lies nearer to a wall than the radius of the robot</source>
        <translation>Das Ziel %1 liegt näher an einer Wand als der Radius des Roboters</translation>
    </message>
    <message>
        <source>No path leads from %1 to %2</source>
        <translation>Kein Weg führt von %1 nach %2</translation>
    </message>
    <message>
        <source>The step between two poses of the path is too small for its length</source>
        <translation>Der Schritt zwischen zwei Posen des Weges ist zu klein für dessen Länge</translation>
    </message>
    <message>
        <source>the projector has no finite, positive cell size and finite origin</source>
        <translation>der Projektor hat keine endliche, positive Zellgröße und keinen endlichen Ursprung</translation>
    </message>
    <message>
        <source>the projector has no finite, positive scale</source>
        <translation>der Projektor hat keinen endlichen, positiven Maßstab</translation>
    </message>
    <message>
        <source>the radius of the projector is not between 0 and 1000 cells</source>
        <translation>der Radius des Projektors liegt nicht zwischen 0 und 1000 Zellen</translation>
    </message>
    <message>
        <source>the projector&apos;s node arrays differ in length</source>
        <translation>die Knotenlisten des Projektors sind verschieden lang</translation>
    </message>
    <message>
        <source>the projector has no node</source>
        <translation>der Projektor hat keinen Knoten</translation>
    </message>
    <message>
        <source>the projector has too many nodes</source>
        <translation>der Projektor hat zu viele Knoten</translation>
    </message>
    <message>
        <source>the projector has two nodes on one tile</source>
        <translation>der Projektor hat zwei Knoten auf einer Kachel</translation>
    </message>
    <message>
        <source>the projector has an edge to a node that does not exist</source>
        <translation>der Projektor hat eine Kante zu einem Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>the projector has an anchor that is not finite</source>
        <translation>der Projektor hat einen Anker, der nicht endlich ist</translation>
    </message>
    <message>
        <source>the names and notes of the projector are too long to be written</source>
        <translation>die Namen und Notizen des Projektors sind zu lang, um geschrieben zu werden</translation>
    </message>
    <message>
        <source>node %1 of the projector lies on a tile outside any building</source>
        <translation>Knoten %1 des Projektors liegt auf einer Kachel außerhalb jedes Gebäudes</translation>
    </message>
    <message>
        <source>node %1 of the projector is not finite</source>
        <translation>Knoten %1 des Projektors ist nicht endlich</translation>
    </message>
    <message>
        <source>node %1 of the projector is stretched beyond reason</source>
        <translation>Knoten %1 des Projektors ist über jedes Maß gedehnt</translation>
    </message>
    <message>
        <source>node %1 of the projector does not lie on its tile</source>
        <translation>Knoten %1 des Projektors liegt nicht auf seiner Kachel</translation>
    </message>
    <message>
        <source>the picture is not as large as its frame says</source>
        <translation>das Bild ist nicht so groß, wie sein Rahmen sagt</translation>
    </message>
    <message>
        <source>pictures wider or higher than %1 pixels cannot be warped; choose a coarser resolution</source>
        <translation>Bilder, die breiter oder höher als %1 Pixel sind, lassen sich nicht verbiegen; eine gröbere Auflösung wählen</translation>
    </message>
    <message>
        <source>the resolution must be a positive number of metres per pixel</source>
        <translation>die Auflösung muss eine positive Zahl von Metern je Pixel sein</translation>
    </message>
    <message>
        <source>the projector draws nothing of this picture</source>
        <translation>der Projektor zeichnet nichts von diesem Bild</translation>
    </message>
    <message>
        <source>the warped picture would be wider than a million pixels; choose a coarser resolution</source>
        <translation>das verbogene Bild wäre breiter als eine Million Pixel; eine gröbere Auflösung wählen</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>lässt sich nicht öffnen (%1)</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>lässt sich nicht schreiben (%1)</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>a file name is missing</source>
        <translation>ein Dateiname fehlt</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes that are read</source>
        <translation>ist größer als die %1 Bytes, die gelesen werden</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>ends too early</source>
        <translation>endet zu früh</translation>
    </message>
    <message>
        <source>was cut off while it was read</source>
        <translation>wurde abgeschnitten, während es gelesen wurde</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Keine Berechtigung</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Die Operation ist nicht erlaubt</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Auf dem Gerät ist kein Speicherplatz mehr frei</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Der zugewiesene Speicherplatz ist überschritten</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Das Dateisystem ist nur lesbar</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Die Datei ist zu groß</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Der Dateiname ist zu lang</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Ist kein Ordner</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Zu viele symbolische Verweise hintereinander</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Das Gerät oder die Ressource ist belegt</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Die Datei auf dem Netzlaufwerk ist nicht mehr gültig</translation>
    </message>
    <message>
        <source>is no image that can be read: PGM, PNG, JPG, BMP and TIFF can</source>
        <translation>ist kein lesbares Bild: PGM, PNG, JPG, BMP und TIFF sind es</translation>
    </message>
    <message>
        <source>is cut off: the image is not complete</source>
        <translation>ist abgeschnitten: das Bild ist nicht vollständig</translation>
    </message>
    <message>
        <source>is an image of %1 x %2 pixels</source>
        <translation>ist ein Bild von %1 x %2 Pixeln</translation>
    </message>
    <message>
        <source>is an image of %1 x %2 pixels; at most 30000 x 30000 are read</source>
        <translation>ist ein Bild von %1 x %2 Pixeln; höchstens 30000 x 30000 werden gelesen</translation>
    </message>
    <message>
        <source>claims %1 x %2 pixels, which its %3 bytes cannot hold</source>
        <translation>gibt %1 x %2 Pixel an, die in seine %3 Bytes nicht passen</translation>
    </message>
    <message>
        <source>is no image: its PNM header does not say width, height and largest value</source>
        <translation>ist kein Bild: sein PNM-Kopf nennt Breite, Höhe und größten Wert nicht</translation>
    </message>
    <message>
        <source>is damaged: wrong checksum in the PNG chunk at byte %1</source>
        <translation>ist beschädigt: falsche Prüfsumme im PNG-Abschnitt bei Byte %1</translation>
    </message>
    <message>
        <source>is damaged: no JPEG segment at byte %1</source>
        <translation>ist beschädigt: kein JPEG-Segment bei Byte %1</translation>
    </message>
    <message>
        <source>is damaged: empty JPEG segment at byte %1</source>
        <translation>ist beschädigt: leeres JPEG-Segment bei Byte %1</translation>
    </message>
    <message>
        <source>is damaged: a JPEG without a frame header</source>
        <translation>ist beschädigt: ein JPEG ohne Bildkopf</translation>
    </message>
    <message>
        <source>is no image: its TIFF directory has too many entries</source>
        <translation>ist kein Bild: sein TIFF-Verzeichnis hat zu viele Einträge</translation>
    </message>
    <message>
        <source>is no image: its TIFF directory does not say width and height</source>
        <translation>ist kein Bild: sein TIFF-Verzeichnis nennt Breite und Höhe nicht</translation>
    </message>
    <message>
        <source>is a damaged image</source>
        <translation>ist ein beschädigtes Bild</translation>
    </message>
    <message>
        <source>is a damaged image: its size is not the one its header says</source>
        <translation>ist ein beschädigtes Bild: seine Größe ist nicht die, die sein Kopf nennt</translation>
    </message>
    <message>
        <source>is too large an image for the memory of this machine</source>
        <translation>ist ein zu großes Bild für den Speicher dieses Rechners</translation>
    </message>
    <message>
        <source>is an image of an unusual kind: 8 or 16 bit grey or colour can be read</source>
        <translation>ist ein Bild ungewöhnlicher Art: lesbar sind Grau oder Farbe mit 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>is an image of an unusual kind: grey, colour, or colour with alpha can be read</source>
        <translation>ist ein Bild ungewöhnlicher Art: lesbar sind Grau, Farbe oder Farbe mit Alpha</translation>
    </message>
    <message>
        <source>is an image with neither 8 nor 16 bits a sample</source>
        <translation>ist ein Bild mit weder 8 noch 16 Bit je Wert</translation>
    </message>
    <message>
        <source>pictures are written as .pgm or .png, not %1</source>
        <translation>Bilder werden als .pgm oder .png geschrieben, nicht als %1</translation>
    </message>
    <message>
        <source>a .pgm holds grey of 8 or 16 bits only; write a .png instead</source>
        <translation>eine .pgm enthält nur Grau mit 8 oder 16 Bit; stattdessen eine .png schreiben</translation>
    </message>
    <message>
        <source>a .png holds grey or colour of 8 or 16 bits only</source>
        <translation>eine .png enthält nur Grau oder Farbe mit 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>the image cannot be encoded</source>
        <translation>das Bild lässt sich nicht kodieren</translation>
    </message>
    <message>
        <source>the image of a map must be a file name without folders</source>
        <translation>das Bild einer Karte muss ein Dateiname ohne Ordner sein</translation>
    </message>
    <message>
        <source>is a damaged image: %1</source>
        <translation>ist ein beschädigtes Bild: %1</translation>
    </message>
    <message>
        <source>there is no room for the temporary tiles of this image</source>
        <translation>für die vorübergehenden Kacheln dieses Bildes ist kein Platz</translation>
    </message>
    <message>
        <source>Grey 205, which map_saver writes for unknown, counts as free with free_thresh %1; 0.196 would keep it unknown.</source>
        <translation>Grau 205, das map_saver für Unbekannt schreibt, zählt mit free_thresh %1 als frei; mit 0.196 bliebe es unbekannt.</translation>
    </message>
    <message>
        <source>%1 pixels were read as %2 read them; %3 would read them differently.</source>
        <translation>%1 Pixel wurden gelesen, wie %2 sie lesen; %3 würden sie anders lesen.</translation>
    </message>
    <message>
        <source>ROS 2 jazzy and later</source>
        <translation>ROS 2 Jazzy und spätere</translation>
    </message>
    <message>
        <source>ROS 1 and ROS 2 up to humble</source>
        <translation>ROS 1 und ROS 2 bis Humble</translation>
    </message>
    <message>
        <source>is too large for a map YAML</source>
        <translation>ist zu groß für die YAML-Datei einer Karte</translation>
    </message>
    <message>
        <source>is not valid YAML (%1)</source>
        <translation>ist kein gültiges YAML (%1)</translation>
    </message>
    <message>
        <source>aliases (*name) are not read</source>
        <translation>Aliase (*name) werden nicht gelesen</translation>
    </message>
    <message>
        <source>the values are nested too deeply</source>
        <translation>die Werte sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a map needs lines such as `image: map.pgm`</source>
        <translation>eine Karte braucht Zeilen wie `image: map.pgm`</translation>
    </message>
    <message>
        <source>a key must be a word</source>
        <translation>ein Schlüssel muss ein Wort sein</translation>
    </message>
    <message>
        <source>holds no map: image and resolution are missing</source>
        <translation>enthält keine Karte: image und resolution fehlen</translation>
    </message>
    <message>
        <source>the key %1 is missing</source>
        <translation>der Schlüssel %1 fehlt</translation>
    </message>
    <message>
        <source>the key %1 already stands in line %2</source>
        <translation>der Schlüssel %1 steht schon in Zeile %2</translation>
    </message>
    <message>
        <source>%1 must be one value, not a list</source>
        <translation>%1 muss ein einzelner Wert sein, keine Liste</translation>
    </message>
    <message>
        <source>%1 must be a number from %2 to %3, not %4</source>
        <translation>%1 muss eine Zahl von %2 bis %3 sein, nicht %4</translation>
    </message>
    <message>
        <source>image must name an image file</source>
        <translation>image muss eine Bilddatei nennen</translation>
    </message>
    <message>
        <source>image is no file name: %1</source>
        <translation>image ist kein Dateiname: %1</translation>
    </message>
    <message>
        <source>origin must be a list of three numbers [x, y, yaw]</source>
        <translation>origin muss eine Liste von drei Zahlen [x, y, yaw] sein</translation>
    </message>
    <message>
        <source>origin holds %1, no finite number</source>
        <translation>origin enthält %1, keine endliche Zahl</translation>
    </message>
    <message>
        <source>free_thresh must not be above occupied_thresh, which is %1</source>
        <translation>free_thresh darf nicht über occupied_thresh liegen, das %1 ist</translation>
    </message>
    <message>
        <source>negate must be 0 or 1, not %1</source>
        <translation>negate muss 0 oder 1 sein, nicht %1</translation>
    </message>
    <message>
        <source>mode must be trinary, scale or raw, not %1</source>
        <translation>mode muss trinary, scale oder raw sein, nicht %1</translation>
    </message>
    <message>
        <source>The yaw of origin is not a number and was read as 0.</source>
        <translation>Die Drehung in origin ist keine Zahl und wurde als 0 gelesen.</translation>
    </message>
    <message>
        <source>The map is turned by a yaw of %1 rad in origin: RViz shows that, navigation and localisation of ROS ignore it.</source>
        <translation>Die Karte ist in origin um %1 rad gedreht: RViz zeigt das, Navigation und Lokalisierung von ROS übergehen es.</translation>
    </message>
    <message>
        <source>holds no anchors</source>
        <translation>enthält keine Anker</translation>
    </message>
    <message>
        <source>is UTF-16 text; save it as UTF-8</source>
        <translation>ist UTF-16-Text; als UTF-8 speichern</translation>
    </message>
    <message>
        <source>the column %1 stands twice in the header</source>
        <translation>die Spalte %1 steht zweimal in der Kopfzeile</translation>
    </message>
    <message>
        <source>the header has no column %1, which anchors need</source>
        <translation>die Kopfzeile hat keine Spalte %1, die Anker brauchen</translation>
    </message>
    <message>
        <source>more than %1 lines are no anchors</source>
        <translation>mehr als %1 Zeilen sind keine Anker</translation>
    </message>
    <message>
        <source>no line can be read as an anchor; the first one %1</source>
        <translation>keine Zeile lässt sich als Anker lesen; die erste: %1</translation>
    </message>
    <message>
        <source>has %1 of at least %2 fields</source>
        <translation>hat %1 von mindestens %2 Feldern</translation>
    </message>
    <message>
        <source>has too few fields</source>
        <translation>hat zu wenige Felder</translation>
    </message>
    <message>
        <source>has a quote that is never closed</source>
        <translation>hat ein Anführungszeichen, das nie geschlossen wird</translation>
    </message>
    <message>
        <source>has text behind a closing quote</source>
        <translation>hat Text hinter einem schließenden Anführungszeichen</translation>
    </message>
    <message>
        <source>the id %1 is not a whole number</source>
        <translation>die id %1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>the id %1 is not from 0 to %2</source>
        <translation>die id %1 liegt nicht zwischen 0 und %2</translation>
    </message>
    <message>
        <source>the id %1 already stands in line %2</source>
        <translation>die id %1 steht schon in Zeile %2</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>%1 is too large for a coordinate</source>
        <translation>%1 ist zu groß für eine Koordinate</translation>
    </message>
    <message>
        <source>enabled is %1, not 1 or 0</source>
        <translation>enabled ist %1, nicht 1 oder 0</translation>
    </message>
    <message>
        <source>enable is %1, not 1 or 0</source>
        <translation>enable ist %1, nicht 1 oder 0</translation>
    </message>
    <message>
        <source>holds no &quot;CorrespondenceAnchor&quot;</source>
        <translation>enthält kein &quot;CorrespondenceAnchor&quot;</translation>
    </message>
    <message>
        <source>more than %1 objects are no anchors</source>
        <translation>mehr als %1 Objekte sind keine Anker</translation>
    </message>
    <message>
        <source>no anchor can be read: %1</source>
        <translation>kein Anker lässt sich lesen: %1</translation>
    </message>
    <message>
        <source>expected %1 instead of %2</source>
        <translation>%1 erwartet statt %2</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>_cad_point or _slam_point</source>
        <translation>_cad_point oder _slam_point</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>des Dateiendes</translation>
    </message>
    <message>
        <source>holds points of QGIS, which are pixels of two images; import it in the app with both of them loaded and export the anchors from there</source>
        <translation>enthält Punkte von QGIS, die Pixel zweier Bilder sind; in der App importieren, wenn beide geladen sind, und die Anker von dort exportieren</translation>
    </message>
    <message>
        <source>Points of QGIS are pixels: load both images first</source>
        <translation>Punkte von QGIS sind Pixel: zuerst beide Bilder laden</translation>
    </message>
    <message>
        <source>has no header with the columns mapX, mapY, sourceX and sourceY</source>
        <translation>hat keine Kopfzeile mit den Spalten mapX, mapY, sourceX und sourceY</translation>
    </message>
    <message>
        <source>holds no points</source>
        <translation>enthält keine Punkte</translation>
    </message>
    <message>
        <source>more than %1 lines are no points</source>
        <translation>mehr als %1 Zeilen sind keine Punkte</translation>
    </message>
    <message>
        <source>its points do not lie in these two maps, neither as metres nor as pixels; were they made with them?</source>
        <translation>seine Punkte liegen nicht in diesen beiden Karten, weder als Meter noch als Pixel; wurden sie mit ihnen gemacht?</translation>
    </message>
    <message>
        <source>is not a project of CAD2SLAM</source>
        <translation>ist kein Projekt von CAD2SLAM</translation>
    </message>
    <message>
        <source>was written by a newer program (format %1); this one reads format %2</source>
        <translation>wurde von einem neueren Programm geschrieben (Format %1); dieses liest Format %2</translation>
    </message>
    <message>
        <source>is too large for a project</source>
        <translation>ist zu groß für ein Projekt</translation>
    </message>
    <message>
        <source>cannot name the file %1, which is not UTF-8</source>
        <translation>kann die Datei %1 nicht nennen, deren Name kein UTF-8 ist</translation>
    </message>
    <message>
        <source>is no text: it holds zero bytes</source>
        <translation>ist kein Text: es enthält Nullbytes</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>is nested too deeply</source>
        <translation>ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>has the key %1 twice in one object</source>
        <translation>hat den Schlüssel %1 zweimal in einem Objekt</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>das Dokument</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 muss ein Objekt sein</translation>
    </message>
    <message>
        <source>%1 must be a list</source>
        <translation>%1 muss eine Liste sein</translation>
    </message>
    <message>
        <source>%1 must be a list of two numbers</source>
        <translation>%1 muss eine Liste von zwei Zahlen sein</translation>
    </message>
    <message>
        <source>%1 must be a list of three numbers: x, y, yaw</source>
        <translation>%1 muss eine Liste von drei Zahlen sein: x, y, Drehung</translation>
    </message>
    <message>
        <source>%1 must be a text</source>
        <translation>%1 muss ein Text sein</translation>
    </message>
    <message>
        <source>%1 must be true or false</source>
        <translation>%1 muss true oder false sein</translation>
    </message>
    <message>
        <source>%1 must be a finite number in its range</source>
        <translation>%1 muss eine endliche Zahl in ihrem Bereich sein</translation>
    </message>
    <message>
        <source>%1 must be a whole number in its range</source>
        <translation>%1 muss eine ganze Zahl in ihrem Bereich sein</translation>
    </message>
    <message>
        <source>%1 must be 64 hexadecimal digits</source>
        <translation>%1 muss aus 64 hexadezimalen Ziffern bestehen</translation>
    </message>
    <message>
        <source>%1 must not be above occupied_thresh</source>
        <translation>%1 darf nicht über occupied_thresh liegen</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 darf nicht leer sein</translation>
    </message>
    <message>
        <source>%1 is not one of the words known here</source>
        <translation>%1 ist keines der hier bekannten Wörter</translation>
    </message>
    <message>
        <source>%1 is no file name</source>
        <translation>%1 ist kein Dateiname</translation>
    </message>
    <message>
        <source>%1 is the name of another map, too: %2</source>
        <translation>%1 ist auch der Name einer anderen Karte: %2</translation>
    </message>
    <message>
        <source>%1 stands twice</source>
        <translation>%1 steht zweimal</translation>
    </message>
    <message>
        <source>%1 stands twice: %2</source>
        <translation>%1 steht zweimal: %2</translation>
    </message>
    <message>
        <source>is not a projector file of CAD2SLAM</source>
        <translation>ist keine Projektordatei von CAD2SLAM</translation>
    </message>
    <message>
        <source>has no known version</source>
        <translation>hat keine bekannte Version</translation>
    </message>
    <message>
        <source>has format version %1; this program reads %2.x</source>
        <translation>hat die Formatversion %1; dieses Programm liest %2.x</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>braucht mehr Speicher, als da ist</translation>
    </message>
    <message>
        <source>is no projector file: it has only %1 bytes</source>
        <translation>ist keine Projektordatei: sie hat nur %1 Bytes</translation>
    </message>
    <message>
        <source>is no projector file: its header would be too long</source>
        <translation>ist keine Projektordatei: ihr Kopf wäre zu lang</translation>
    </message>
    <message>
        <source>is no projector file: zero bytes in its header</source>
        <translation>ist keine Projektordatei: Nullbytes in ihrem Kopf</translation>
    </message>
    <message>
        <source>is cut off inside its header</source>
        <translation>ist in ihrem Kopf abgeschnitten</translation>
    </message>
    <message>
        <source>is cut off: %1 bytes are missing</source>
        <translation>ist abgeschnitten: %1 Bytes fehlen</translation>
    </message>
    <message>
        <source>has %1 bytes too many</source>
        <translation>hat %1 Bytes zu viel</translation>
    </message>
    <message>
        <source>is damaged: its header was changed</source>
        <translation>ist beschädigt: ihr Kopf wurde verändert</translation>
    </message>
    <message>
        <source>is damaged: its data do not have the SHA-256 they should</source>
        <translation>ist beschädigt: ihre Daten haben nicht den SHA-256, den sie haben sollten</translation>
    </message>
    <message>
        <source>has no data_sha256</source>
        <translation>hat kein data_sha256</translation>
    </message>
    <message>
        <source>has no array %1</source>
        <translation>hat keine Liste %1</translation>
    </message>
    <message>
        <source>has an array %1 that is not %2 in %3 columns</source>
        <translation>hat eine Liste %1, die nicht %2 in %3 Spalten ist</translation>
    </message>
    <message>
        <source>has node arrays of different lengths</source>
        <translation>hat Knotenlisten verschiedener Länge</translation>
    </message>
    <message>
        <source>has an edge to a node that does not exist</source>
        <translation>hat eine Kante zu einem Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>has an anchor that is not finite</source>
        <translation>hat einen Anker, der nicht endlich ist</translation>
    </message>
    <message>
        <source>has a check pose that is not finite</source>
        <translation>hat eine Prüfpose, die nicht endlich ist</translation>
    </message>
    <message>
        <source>does not reproduce its own check pose %1</source>
        <translation>gibt ihre eigene Prüfpose %1 nicht wieder</translation>
    </message>
    <message>
        <source>has an array of unknown type or impossible size: %1</source>
        <translation>hat eine Liste von unbekanntem Typ oder unmöglicher Größe: %1</translation>
    </message>
    <message>
        <source>has an array whose range does not fit its shape: %1</source>
        <translation>hat eine Liste, deren Bereich nicht zu ihrer Form passt: %1</translation>
    </message>
    <message>
        <source>has arrays that overlap or leave a gap at byte %1</source>
        <translation>hat Listen, die sich überlappen oder eine Lücke lassen, bei Byte %1</translation>
    </message>
    <message>
        <source>has a header that %1</source>
        <translation>hat einen unlesbaren Kopf: er %1</translation>
    </message>
    <message>
        <source>is no JSON object</source>
        <translation>ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>is not valid JSON at byte %1</source>
        <translation>ist kein gültiges JSON bei Byte %1</translation>
    </message>
    <message>
        <source>has the name %1 twice</source>
        <translation>hat den Namen %1 zweimal</translation>
    </message>
    <message>
        <source>has the key %1 twice in %2</source>
        <translation>hat den Schlüssel %1 zweimal in %2</translation>
    </message>
    <message>
        <source>has the unknown key %1 in %2</source>
        <translation>hat den unbekannten Schlüssel %1 in %2</translation>
    </message>
    <message>
        <source>has too many arrays</source>
        <translation>hat zu viele Listen</translation>
    </message>
    <message>
        <source>has too long a list in %1</source>
        <translation>hat eine zu lange Liste in %1</translation>
    </message>
    <message>
        <source>does not say dtype, shape and data_offsets of %1</source>
        <translation>nennt dtype, shape und data_offsets von %1 nicht</translation>
    </message>
    <message>
        <source>has data_offsets that are not two numbers in %1</source>
        <translation>hat data_offsets, die keine zwei Zahlen sind, in %1</translation>
    </message>
    <message>
        <source>has %1 where it should not, in %2</source>
        <translation>hat %1, wo das nicht stehen sollte, in %2</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>a truth value</source>
        <translation>einen Wahrheitswert</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a negative number</source>
        <translation>eine negative Zahl</translation>
    </message>
    <message>
        <source>a number with a fraction</source>
        <translation>eine gebrochene Zahl</translation>
    </message>
    <message>
        <source>binary data</source>
        <translation>Binärdaten</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>einen Text</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>the metadata %1 is missing</source>
        <translation>die Angabe %1 fehlt in den Metadaten</translation>
    </message>
    <message>
        <source>the metadata %1 is %2, not a finite number</source>
        <translation>die Angabe %1 in den Metadaten ist %2, keine endliche Zahl</translation>
    </message>
    <message>
        <source>the metadata %1 is %2, not a whole number from 0 on</source>
        <translation>die Angabe %1 in den Metadaten ist %2, keine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>the metadata %1 is %2, which is not known</source>
        <translation>die Angabe %1 in den Metadaten ist %2, was nicht bekannt ist</translation>
    </message>
    <message>
        <source>the metadata %1 is not 64 hexadecimal digits</source>
        <translation>die Angabe %1 in den Metadaten besteht nicht aus 64 hexadezimalen Ziffern</translation>
    </message>
    <message>
        <source>There is not enough memory for this; use larger cells or a smaller image</source>
        <translation>Dafür reicht der Speicher nicht; größere Zellen oder ein kleineres Bild nehmen</translation>
    </message>
    <message>
        <source>Something went wrong inside the program</source>
        <translation>Im Programm ist etwas schiefgegangen</translation>
    </message>
    <message>
        <source>Something went wrong inside the program: %1</source>
        <translation>Im Programm ist etwas schiefgegangen: %1</translation>
    </message>
    <message>
        <source>not loaded</source>
        <translation>nicht geladen</translation>
    </message>
    <message>
        <source>there is nothing to lay over the map</source>
        <translation>es gibt nichts, was über die Karte gelegt werden könnte</translation>
    </message>
    <message>
        <source>There is no up-to-date alignment to export</source>
        <translation>Es gibt keine aktuelle Ausrichtung zum Exportieren</translation>
    </message>
    <message>
        <source>The export was cancelled, nothing was written</source>
        <translation>Der Export wurde abgebrochen, nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>The file reads back with other values</source>
        <translation>Die Datei liest sich mit anderen Werten zurück</translation>
    </message>
    <message>
        <source>The file reads back with other values: do not use it</source>
        <translation>Die Datei liest sich mit anderen Werten zurück: nicht benutzen</translation>
    </message>
    <message>
        <source>Going there and back through the file does not return to the start</source>
        <translation>Hin und zurück durch die Datei führt nicht zum Ausgangspunkt</translation>
    </message>
    <message>
        <source>1 part of the free space (1 node) is not connected to any anchor and only follows the global fit.</source>
        <translation>1 Teil der freien Fläche (1 Knoten) ist mit keinem Anker verbunden und folgt nur der globalen Ausrichtung.</translation>
    </message>
    <message>
        <source>1 part of the free space (%1 nodes) is not connected to any anchor and only follows the global fit.</source>
        <translation>1 Teil der freien Fläche (%1 Knoten) ist mit keinem Anker verbunden und folgt nur der globalen Ausrichtung.</translation>
    </message>
    <message>
        <source>%1 parts of the free space (%2 nodes) are not connected to any anchor and only follow the global fit.</source>
        <translation>%1 Teile der freien Fläche (%2 Knoten) sind mit keinem Anker verbunden und folgen nur der globalen Ausrichtung.</translation>
    </message>
</context>
<context>
    <name>Hints</name>
    <message>
        <source>Choose the blueprint: drop its YAML or image into the left view</source>
        <translation>Bauplan wählen: seine YAML-Datei oder sein Bild in die linke Ansicht ziehen</translation>
    </message>
    <message>
        <source>Choose the SLAM map: drop its YAML or image into the right view</source>
        <translation>SLAM-Karte wählen: ihre YAML-Datei oder ihr Bild in die rechte Ansicht ziehen</translation>
    </message>
    <message>
        <source>Loading the images...</source>
        <translation>Bilder werden geladen...</translation>
    </message>
    <message>
        <source>An image is missing; see the message above</source>
        <translation>Ein Bild fehlt; siehe die Meldung oben</translation>
    </message>
    <message>
        <source>Anchors are locked for looking only (K unlocks)</source>
        <translation>Anker sind gesperrt, nur zum Ansehen (K entsperrt)</translation>
    </message>
    <message>
        <source>Now click the same place in the SLAM map (Esc cancels)</source>
        <translation>Jetzt dieselbe Stelle in der SLAM-Karte anklicken (Esc bricht ab)</translation>
    </message>
    <message>
        <source>Now click the same place in the blueprint (Esc cancels)</source>
        <translation>Jetzt dieselbe Stelle im Bauplan anklicken (Esc bricht ab)</translation>
    </message>
    <message>
        <source>Click a corner or pillar in either view</source>
        <translation>Eine Ecke oder einen Pfeiler in einer der Ansichten anklicken</translation>
    </message>
    <message>
        <source>Rotation unknown: add another anchor far away from the first</source>
        <translation>Drehung unbekannt: einen zweiten Anker weit weg vom ersten setzen</translation>
    </message>
    <message>
        <source>Rough alignment; add more anchors, best in rooms that have none yet</source>
        <translation>Grobe Ausrichtung; weitere Anker setzen, am besten in Räumen ohne Anker</translation>
    </message>
    <message>
        <source>Add a fourth anchor, then each one is checked by the others</source>
        <translation>Einen vierten Anker setzen, dann prüfen die anderen jeden einzelnen</translation>
    </message>
    <message>
        <source>Add anchors where the overlay is off; look at the worst one with N</source>
        <translation>Anker setzen, wo die Überlagerung nicht passt; den schlechtesten zeigt N</translation>
    </message>
    <message>
        <source>no alignment</source>
        <translation>keine Ausrichtung</translation>
    </message>
    <message>
        <source>Both images are needed</source>
        <translation>Beide Bilder werden gebraucht</translation>
    </message>
    <message>
        <source>no anchors</source>
        <translation>keine Anker</translation>
    </message>
    <message>
        <source>Nothing to solve yet</source>
        <translation>Noch nichts zu lösen</translation>
    </message>
    <message>
        <source>solving...</source>
        <translation>löst...</translation>
    </message>
    <message>
        <source>Click to stop (Ctrl+.)</source>
        <translation>Klick hält an (Strg+.)</translation>
    </message>
    <message>
        <source>up to date, %1 s</source>
        <translation>aktuell, %1 s</translation>
    </message>
    <message>
        <source>%1 nodes, %2 iterations</source>
        <translation>%1 Knoten, %2 Iterationen</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>Click to solve again (F5)</source>
        <translation>Klick löst noch einmal (F5)</translation>
    </message>
    <message>
        <source>Click the same place in the SLAM map, or press Enter to take the predicted place (Esc cancels)</source>
        <translation>Dieselbe Stelle in der SLAM-Karte anklicken oder mit Enter die vorhergesagte Stelle nehmen (Esc bricht ab)</translation>
    </message>
    <message>
        <source>Click the same place in the blueprint, or press Enter to take the predicted place (Esc cancels)</source>
        <translation>Dieselbe Stelle im Bauplan anklicken oder mit Enter die vorhergesagte Stelle nehmen (Esc bricht ab)</translation>
    </message>
    <message>
        <source>solving the others...</source>
        <translation>löst die anderen...</translation>
    </message>
    <message>
        <source>The other SLAM maps are solved for the preview; click to stop (Ctrl+.)</source>
        <translation>Die anderen SLAM-Karten werden für die Vorschau gelöst; ein Klick hält an (Strg+.)</translation>
    </message>
    <message>
        <source>The alignment could not be solved; see the message above</source>
        <translation>Die Ausrichtung ließ sich nicht lösen; siehe die Meldung oben</translation>
    </message>
    <message>
        <source>The alignment was stopped: F5 solves it again</source>
        <translation>Die Ausrichtung wurde angehalten: F5 löst sie neu</translation>
    </message>
    <message>
        <source>Solving the alignment...</source>
        <translation>Die Ausrichtung wird gelöst ...</translation>
    </message>
    <message>
        <source>No anchor is used: switch some on in the table, or place new ones</source>
        <translation>Kein Anker wird verwendet: in der Tabelle einschalten oder neue setzen</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>fehlgeschlagen: %1</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>&amp;Karten</translation>
    </message>
    <message>
        <source>SLAM map being &amp;edited</source>
        <translation>&amp;Bearbeitete SLAM-Karte</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>P&amp;anels</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Main tool bar</source>
        <translation>Hauptwerkzeugleiste</translation>
    </message>
</context>
<context>
    <name>ProgramActions</name>
    <message>
        <source>The language changes at the next start of the program</source>
        <translation>Die Sprache wechselt beim nächsten Start des Programms</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>About CAD2SLAM</source>
        <translation>Über CAD2SLAM</translation>
    </message>
    <message>
        <source>&lt;h3&gt;CAD2SLAM %1&lt;/h3&gt;&lt;p&gt;Projects poses between building blueprints and robot SLAM maps.&lt;/p&gt;&lt;p&gt;Apache License 2.0. Uses Qt, Ceres, SuiteSparse, OpenCV and Eigen.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;CAD2SLAM %1&lt;/h3&gt;&lt;p&gt;Überträgt Posen zwischen Bauplänen und SLAM-Karten von Robotern.&lt;/p&gt;&lt;p&gt;Apache-Lizenz 2.0. Verwendet Qt, Ceres, SuiteSparse, OpenCV und Eigen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Bauplan</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>SLAM-Karte</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Bericht nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Show poses from file</source>
        <translation>Posen aus Datei zeigen</translation>
    </message>
    <message>
        <source>Poses (*.csv *.txt);;All files (*)</source>
        <translation>Posen (*.csv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Show poses</source>
        <translation>Posen zeigen</translation>
    </message>
    <message>
        <source>The poses are in the frame of the:</source>
        <translation>Die Posen gelten im Rahmen von:</translation>
    </message>
    <message>
        <source>%1 poses shown</source>
        <translation>%1 Posen gezeigt</translation>
    </message>
    <message>
        <source>No line of %1 starts with two numbers x, y</source>
        <translation>Keine Zeile von %1 beginnt mit zwei Zahlen x, y</translation>
    </message>
    <message>
        <source>%1 lines without two numbers left out</source>
        <translation>%1 Zeilen ohne zwei Zahlen ausgelassen</translation>
    </message>
    <message>
        <source>There are more: only the first are shown</source>
        <translation>Es gibt mehr: nur die ersten werden gezeigt</translation>
    </message>
    <message>
        <source>the clipboard</source>
        <translation>der Zwischenablage</translation>
    </message>
    <message>
        <source>Both maps: blueprint magenta, SLAM map green, dark where they agree</source>
        <translation>Beide Karten: Bauplan magenta, SLAM-Karte grün, dunkel wo sie übereinstimmen</translation>
    </message>
    <message>
        <source>Test pose in the blueprint</source>
        <translation>Testpose im Bauplan</translation>
    </message>
    <message>
        <source>Test pose in the SLAM map</source>
        <translation>Testpose in der SLAM-Karte</translation>
    </message>
    <message>
        <source>&amp;x (m):</source>
        <translation>&amp;x (m):</translation>
    </message>
    <message>
        <source>&amp;y (m):</source>
        <translation>&amp;y (m):</translation>
    </message>
    <message>
        <source>&amp;Heading (degrees):</source>
        <translation>&amp;Richtung (Grad):</translation>
    </message>
    <message>
        <source>A pose of the SLAM map can be shown once there is an alignment</source>
        <translation>Eine Pose der SLAM-Karte kann gezeigt werden, sobald es eine Ausrichtung gibt</translation>
    </message>
    <message>
        <source>A report is about a blueprint and a SLAM map: load both first</source>
        <translation>Ein Bericht handelt von einem Bauplan und einer SLAM-Karte: laden Sie zuerst beide</translation>
    </message>
</context>
<context>
    <name>Limits</name>
    <message>
        <source>Judged by the error without it, below %1 anchors by the residual; the larger limit counts:</source>
        <translation>Beurteilt nach dem Fehler ohne ihn, unter %1 Ankern nach dem Restfehler; die größere Grenze zählt:</translation>
    </message>
    <message>
        <source>● OK up to %1 or %2 pixels of the SLAM map</source>
        <translation>● OK bis %1 oder %2 Pixel der SLAM-Karte</translation>
    </message>
    <message>
        <source>◆ Have a look up to %1 or %2 pixels</source>
        <translation>◆ Ansehen bis %1 oder %2 Pixel</translation>
    </message>
    <message>
        <source>■ Bad beyond that, if it is also more than %1 times the median or the residual is not OK</source>
        <translation>■ Schlecht darüber, wenn es auch mehr als das %1-Fache des Medians beträgt oder der Restfehler nicht OK ist</translation>
    </message>
    <message>
        <source>■ From %1 anchors on also bad: not OK and more than %2 standard deviations above the mean</source>
        <translation>■ Ab %1 Ankern auch schlecht: nicht OK und mehr als %2 Standardabweichungen über dem Mittel</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>look</source>
        <translation>ansehen</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>off (check)</source>
        <translation>aus (Kontrolle)</translation>
    </message>
    <message>
        <source>%1 m/px</source>
        <translation>%1 m/px</translation>
    </message>
    <message>
        <source>Project not saved</source>
        <translation>Projekt nicht gespeichert</translation>
    </message>
    <message>
        <source>CAD2SLAM %1, %2</source>
        <translation>CAD2SLAM %1, %2</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Anchors used</source>
        <translation>Benutzte Anker</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>RMS of the residuals</source>
        <translation>Quadratisches Mittel der Restfehler</translation>
    </message>
    <message>
        <source>Largest residual</source>
        <translation>Größter Restfehler</translation>
    </message>
    <message>
        <source>Median error without the anchor itself</source>
        <translation>Mittlerer Fehler ohne den Anker selbst (Median)</translation>
    </message>
    <message>
        <source>Turn and scale of the SLAM map</source>
        <translation>Drehung und Maßstab der SLAM-Karte</translation>
    </message>
    <message>
        <source>%1°, %2</source>
        <translation>%1°, %2</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>%1 nodes, cells of %2 m, folded tiles: %3</source>
        <translation>%1 Knoten, Zellen von %2 m, gefaltete Kacheln: %3</translation>
    </message>
    <message>
        <source>To look at</source>
        <translation>Anzusehen</translation>
    </message>
    <message>
        <source>Anchors</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Blueprint x, y (m)</source>
        <translation>Bauplan x, y (m)</translation>
    </message>
    <message>
        <source>SLAM map x, y (m)</source>
        <translation>SLAM-Karte x, y (m)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Without it</source>
        <translation>Ohne ihn</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>SHA-256 (first 16)</source>
        <translation>SHA-256 (erste 16)</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Bauplan</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>SLAM-Karte</translation>
    </message>
    <message>
        <source>CAD2SLAM report</source>
        <translation>CAD2SLAM-Bericht</translation>
    </message>
    <message>
        <source>The project has changes that are not saved in its file.</source>
        <translation>Das Projekt hat Änderungen, die nicht in seiner Datei gespeichert sind.</translation>
    </message>
    <message>
        <source>The figures below are those of an earlier state: the project as it is was not solved.</source>
        <translation>Die Zahlen unten gehören zu einem früheren Stand: das Projekt, wie es ist, wurde nicht gelöst.</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
</context>
<context>
    <name>SavePath</name>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
</context>
<context>
    <name>StatusStrip</name>
    <message>
        <source>What to do next</source>
        <translation>Was als Nächstes zu tun ist</translation>
    </message>
</context>
<context>
    <name>cad2slam::Actions</name>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>Start with an empty project</source>
        <translation>Mit einem leeren Projekt beginnen</translation>
    </message>
    <message>
        <source>&amp;Open project...</source>
        <translation>Projekt ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open a project file</source>
        <translation>Eine Projektdatei öffnen</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>Projekt &amp;speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>Projekt speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Das Projekt unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Choose &amp;blueprint...</source>
        <translation>&amp;Bauplan wählen...</translation>
    </message>
    <message>
        <source>Choose the plan of the building: a map YAML or an image</source>
        <translation>Den Plan des Gebäudes wählen: Karten-YAML oder Bild</translation>
    </message>
    <message>
        <source>Add SLAM &amp;map...</source>
        <translation>SLAM-&amp;Karte hinzufügen...</translation>
    </message>
    <message>
        <source>Add a robot&apos;s map: a map YAML or an image</source>
        <translation>Die Karte eines Roboters hinzufügen: Karten-YAML oder Bild</translation>
    </message>
    <message>
        <source>&amp;Import anchors...</source>
        <translation>Anker &amp;importieren...</translation>
    </message>
    <message>
        <source>Read anchors from a CSV file</source>
        <translation>Anker aus einer CSV-Datei lesen</translation>
    </message>
    <message>
        <source>Export an&amp;chors...</source>
        <translation>Anker e&amp;xportieren...</translation>
    </message>
    <message>
        <source>Write the anchors to a CSV file</source>
        <translation>Die Anker in eine CSV-Datei schreiben</translation>
    </message>
    <message>
        <source>&amp;Export projector...</source>
        <translation>&amp;Projektor exportieren...</translation>
    </message>
    <message>
        <source>Write the file that robots use</source>
        <translation>Die Datei schreiben, die Roboter benutzen</translation>
    </message>
    <message>
        <source>Inspect a pro&amp;jector...</source>
        <translation>Pro&amp;jektor ansehen...</translation>
    </message>
    <message>
        <source>Tell what a projector file was made from</source>
        <translation>Zeigen, woraus ein Projektor gemacht wurde</translation>
    </message>
    <message>
        <source>Save &amp;report...</source>
        <translation>Be&amp;richt speichern...</translation>
    </message>
    <message>
        <source>Write a report with pictures as PDF</source>
        <translation>Einen Bericht mit Bildern als PDF schreiben</translation>
    </message>
    <message>
        <source>Se&amp;ttings...</source>
        <translation>&amp;Einstellungen...</translation>
    </message>
    <message>
        <source>Solver, limits and appearance</source>
        <translation>Löser, Grenzen und Aussehen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Das Programm schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last step</source>
        <translation>Den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Do the step again</source>
        <translation>Den Schritt noch einmal tun</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the selected anchors</source>
        <translation>Die ausgewählten Anker löschen</translation>
    </message>
    <message>
        <source>&amp;Use / do not use</source>
        <translation>&amp;Benutzen / nicht benutzen</translation>
    </message>
    <message>
        <source>Switch the selected anchors on or off</source>
        <translation>Die ausgewählten Anker ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>Umbe&amp;nennen...</translation>
    </message>
    <message>
        <source>Give the selected anchor a name</source>
        <translation>Dem ausgewählten Anker einen Namen geben</translation>
    </message>
    <message>
        <source>&amp;Type coordinates...</source>
        <translation>Koordinaten ein&amp;geben...</translation>
    </message>
    <message>
        <source>Add an anchor, or change the selected one, by numbers</source>
        <translation>Einen Anker durch Zahlen hinzufügen oder den ausgewählten ändern</translation>
    </message>
    <message>
        <source>S&amp;wap counterparts</source>
        <translation>&amp;Gegenstücke tauschen</translation>
    </message>
    <message>
        <source>Exchange the SLAM points of the two selected anchors</source>
        <translation>Die SLAM-Punkte der zwei ausgewählten Anker tauschen</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alle auswählen</translation>
    </message>
    <message>
        <source>Select all anchors</source>
        <translation>Alle Anker auswählen</translation>
    </message>
    <message>
        <source>Disable &amp;worst</source>
        <translation>&amp;Schlechtesten abschalten</translation>
    </message>
    <message>
        <source>Do not use the anchor with the largest error</source>
        <translation>Den Anker mit dem größten Fehler nicht benutzen</translation>
    </message>
    <message>
        <source>&amp;Lock anchors</source>
        <translation>Anker s&amp;perren</translation>
    </message>
    <message>
        <source>Look only: no anchor can be changed</source>
        <translation>Nur ansehen: kein Anker kann geändert werden</translation>
    </message>
    <message>
        <source>&amp;Snap to corners</source>
        <translation>An &amp;Ecken einrasten</translation>
    </message>
    <message>
        <source>Clicks go to the corner that is shown; hold Alt to suspend</source>
        <translation>Klicks gehen zur gezeigten Ecke; Alt gedrückt halten setzt aus</translation>
    </message>
    <message>
        <source>&amp;Rescale blueprint...</source>
        <translation>Bauplan &amp;skalieren...</translation>
    </message>
    <message>
        <source>Correct the scale of the blueprint; anchors keep their places</source>
        <translation>Den Maßstab des Bauplans berichtigen; Anker behalten ihre Stelle</translation>
    </message>
    <message>
        <source>&amp;Mirror blueprint</source>
        <translation>Bauplan &amp;spiegeln</translation>
    </message>
    <message>
        <source>Mirror the blueprint left to right; anchors keep their places</source>
        <translation>Den Bauplan links-rechts spiegeln; Anker behalten ihre Stelle</translation>
    </message>
    <message>
        <source>Rename SLAM map...</source>
        <translation>SLAM-Karte umbenennen...</translation>
    </message>
    <message>
        <source>Give the SLAM map another name</source>
        <translation>Der SLAM-Karte einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Remove SLAM map</source>
        <translation>SLAM-Karte entfernen</translation>
    </message>
    <message>
        <source>Take this SLAM map and its anchors out of the project</source>
        <translation>Diese SLAM-Karte und ihre Anker aus dem Projekt nehmen</translation>
    </message>
    <message>
        <source>&amp;Copy anchors from...</source>
        <translation>Anker &amp;kopieren von...</translation>
    </message>
    <message>
        <source>Take over the blueprint points of another SLAM map&apos;s anchors</source>
        <translation>Die Bauplanpunkte der Anker einer anderen SLAM-Karte übernehmen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>Das ganze Bild zeigen</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>One image pixel for each screen pixel</source>
        <translation>Ein Bildpixel je Bildschirmpixel</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Vergrößern</translation>
    </message>
    <message>
        <source>Show less, larger</source>
        <translation>Weniger zeigen, größer</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Show more, smaller</source>
        <translation>Mehr zeigen, kleiner</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn this view by 15 degrees to the left</source>
        <translation>Diese Ansicht um 15 Grad nach links drehen</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turn this view by 15 degrees to the right</source>
        <translation>Diese Ansicht um 15 Grad nach rechts drehen</translation>
    </message>
    <message>
        <source>Turn &amp;back</source>
        <translation>&amp;Zurückdrehen</translation>
    </message>
    <message>
        <source>Show this view upright again</source>
        <translation>Diese Ansicht wieder aufrecht zeigen</translation>
    </message>
    <message>
        <source>&amp;Centre on anchor</source>
        <translation>Auf Anker &amp;zentrieren</translation>
    </message>
    <message>
        <source>Show the selected anchor in the middle of both views</source>
        <translation>Den ausgewählten Anker in beiden Ansichten in die Mitte stellen</translation>
    </message>
    <message>
        <source>&amp;Next by error</source>
        <translation>&amp;Nächster nach Fehler</translation>
    </message>
    <message>
        <source>Go to the anchor with the next smaller error</source>
        <translation>Zum Anker mit dem nächstkleineren Fehler gehen</translation>
    </message>
    <message>
        <source>&amp;Previous by error</source>
        <translation>&amp;Voriger nach Fehler</translation>
    </message>
    <message>
        <source>Go to the anchor with the next larger error</source>
        <translation>Zum Anker mit dem nächstgrößeren Fehler gehen</translation>
    </message>
    <message>
        <source>Lin&amp;k views</source>
        <translation>Ansichten &amp;koppeln</translation>
    </message>
    <message>
        <source>Both views show the same place, turned the same way</source>
        <translation>Beide Ansichten zeigen dieselbe Stelle, gleich gedreht</translation>
    </message>
    <message>
        <source>Other view goes &amp;here</source>
        <translation>Andere Ansicht &amp;hierher</translation>
    </message>
    <message>
        <source>The other view shows what this one shows</source>
        <translation>Die andere Ansicht zeigt, was diese zeigt</translation>
    </message>
    <message>
        <source>Go where the &amp;other is</source>
        <translation>Dorthin, wo die &amp;andere ist</translation>
    </message>
    <message>
        <source>This view shows what the other one shows</source>
        <translation>Diese Ansicht zeigt, was die andere zeigt</translation>
    </message>
    <message>
        <source>&amp;Loupe</source>
        <translation>&amp;Lupe</translation>
    </message>
    <message>
        <source>Magnify what is under the cursor; hold Z for a moment</source>
        <translation>Vergrößern, was unter dem Zeiger ist; Z halten für einen Augenblick</translation>
    </message>
    <message>
        <source>&amp;Markers</source>
        <translation>&amp;Marken</translation>
    </message>
    <message>
        <source>Show or hide the anchors</source>
        <translation>Die Anker zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Beschriftung</translation>
    </message>
    <message>
        <source>Show or hide numbers and names</source>
        <translation>Nummern und Namen zeigen oder verbergen</translation>
    </message>
    <message>
        <source>M&amp;esh</source>
        <translation>N&amp;etz</translation>
    </message>
    <message>
        <source>Show the mesh; colours tell how much it is stretched</source>
        <translation>Das Netz zeigen; Farben sagen, wie sehr es gedehnt ist</translation>
    </message>
    <message>
        <source>Resi&amp;duals</source>
        <translation>&amp;Restfehler</translation>
    </message>
    <message>
        <source>Show what each anchor misses</source>
        <translation>Zeigen, was jedem Anker fehlt</translation>
    </message>
    <message>
        <source>Residuals &amp;x10</source>
        <translation>Restfehler &amp;x10</translation>
    </message>
    <message>
        <source>Draw residuals ten times as long</source>
        <translation>Restfehler zehnmal so lang zeichnen</translation>
    </message>
    <message>
        <source>Test &amp;pose</source>
        <translation>Test&amp;pose</translation>
    </message>
    <message>
        <source>Drag a robot in either view and see it in the other</source>
        <translation>Einen Roboter in einer Ansicht ziehen und in der anderen sehen</translation>
    </message>
    <message>
        <source>Show poses &amp;from file...</source>
        <translation>Posen aus &amp;Datei zeigen...</translation>
    </message>
    <message>
        <source>Show a CSV of poses in both views</source>
        <translation>Eine CSV mit Posen in beiden Ansichten zeigen</translation>
    </message>
    <message>
        <source>Plan a pa&amp;th</source>
        <translation>&amp;Weg planen</translation>
    </message>
    <message>
        <source>Show the way from the first to the second test pose in both views</source>
        <translation>Den Weg von der ersten zur zweiten Testpose in beiden Ansichten zeigen</translation>
    </message>
    <message>
        <source>Next part of the window</source>
        <translation>Nächster Teil des Fensters</translation>
    </message>
    <message>
        <source>Go on with the keyboard in the next part of the window</source>
        <translation>Mit der Tastatur im nächsten Teil des Fensters weitermachen</translation>
    </message>
    <message>
        <source>&amp;Solve again</source>
        <translation>Noch einmal &amp;lösen</translation>
    </message>
    <message>
        <source>Compute the alignment again</source>
        <translation>Die Ausrichtung noch einmal berechnen</translation>
    </message>
    <message>
        <source>St&amp;op solving</source>
        <translation>Lösen an&amp;halten</translation>
    </message>
    <message>
        <source>Stop the computation; the last result stays</source>
        <translation>Die Berechnung anhalten; das letzte Ergebnis bleibt</translation>
    </message>
    <message>
        <source>Next preview &amp;mode</source>
        <translation>Nächste &amp;Vorschauart</translation>
    </message>
    <message>
        <source>Overlay, two inks, swipe, blink, lens, ...</source>
        <translation>Überlagerung, zwei Tinten, Wischen, Blinken, Linse, ...</translation>
    </message>
    <message>
        <source>&amp;Less overlay</source>
        <translation>&amp;Weniger Überlagerung</translation>
    </message>
    <message>
        <source>Make the overlay more transparent</source>
        <translation>Die Überlagerung durchsichtiger machen</translation>
    </message>
    <message>
        <source>M&amp;ore overlay</source>
        <translation>&amp;Mehr Überlagerung</translation>
    </message>
    <message>
        <source>Make the overlay more opaque</source>
        <translation>Die Überlagerung deckender machen</translation>
    </message>
    <message>
        <source>Swap preview &amp;direction</source>
        <translation>&amp;Richtung der Vorschau tauschen</translation>
    </message>
    <message>
        <source>Blueprint over SLAM map, or SLAM map over blueprint</source>
        <translation>Bauplan über SLAM-Karte oder SLAM-Karte über Bauplan</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Hoher Kontrast</translation>
    </message>
    <message>
        <source>For bright sunlight</source>
        <translation>Für helle Sonne</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>All keys on one page</source>
        <translation>Alle Tasten auf einer Seite</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>&amp;Geführter Rundgang</translation>
    </message>
    <message>
        <source>A few steps on a sample building</source>
        <translation>Ein paar Schritte an einem Beispielgebäude</translation>
    </message>
    <message>
        <source>&amp;About CAD2SLAM</source>
        <translation>&amp;Über CAD2SLAM</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Show poses from the &amp;clipboard...</source>
        <translation>Posen aus der &amp;Zwischenablage zeigen ...</translation>
    </message>
    <message>
        <source>Show copied lines x, y, heading in both views</source>
        <translation>Kopierte Zeilen x, y, Richtung in beiden Ansichten zeigen</translation>
    </message>
    <message>
        <source>&amp;Remove shown poses</source>
        <translation>Gezeigte Posen &amp;entfernen</translation>
    </message>
    <message>
        <source>Take the poses from file or clipboard away again</source>
        <translation>Die Posen aus Datei oder Zwischenablage wieder wegnehmen</translation>
    </message>
    <message>
        <source>Place a &amp;point in the middle</source>
        <translation>&amp;Punkt in der Mitte setzen</translation>
    </message>
    <message>
        <source>As a click in the middle of the view, where the arrow keys have moved it</source>
        <translation>Wie ein Klick in die Mitte der Ansicht, wohin die Pfeiltasten sie geschoben haben</translation>
    </message>
    <message>
        <source>Test pose by &amp;numbers...</source>
        <translation>Testpose als &amp;Zahlen...</translation>
    </message>
    <message>
        <source>Put the robot to x, y and heading in the frame of this view</source>
        <translation>Den Roboter auf x, y und Richtung in den Koordinaten dieser Ansicht setzen</translation>
    </message>
</context>
<context>
    <name>cad2slam::AnchorEditing</name>
    <message>
        <source>A pixel can be from %1 to %2 metres wide</source>
        <translation>Ein Pixel kann von %1 bis %2 Meter breit sein</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Anchor %1 deleted</source>
        <translation>Anker %1 gelöscht</translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) deleted</source>
        <translation>
            <numerusform>%n Anker gelöscht</numerusform>
            <numerusform>%n Anker gelöscht</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Anchor %1 is no longer used; it was off by %2</source>
        <translation>Anker %1 wird nicht mehr benutzt; er lag %2 daneben</translation>
    </message>
    <message>
        <source>Rescale blueprint</source>
        <translation>Bauplan skalieren</translation>
    </message>
    <message>
        <source>Metres for each pixel of the blueprint:</source>
        <translation>Meter je Pixel des Bauplans:</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a length above zero</source>
        <translation>„%1“ ist keine Länge über null</translation>
    </message>
    <message>
        <source>Copy anchors</source>
        <translation>Anker kopieren</translation>
    </message>
    <message>
        <source>From SLAM map:</source>
        <translation>Von SLAM-Karte:</translation>
    </message>
    <message>
        <source>copied from %1; move its SLAM point to the right place, then switch it on</source>
        <translation>kopiert von %1; seinen SLAM-Punkt an die richtige Stelle schieben, dann einschalten</translation>
    </message>
    <message>
        <source>copy anchors from %1</source>
        <translation>Anker kopieren von %1</translation>
    </message>
    <message>
        <source>Anchors are locked for looking only</source>
        <translation>Die Anker sind gesperrt: nur ansehen</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Coordinates of anchor %1</source>
        <translation>Koordinaten von Anker %1</translation>
    </message>
    <message>
        <source>New anchor %1</source>
        <translation>Neuer Anker %1</translation>
    </message>
    <message>
        <source>Blueprint &amp;x (m):</source>
        <translation>Bauplan &amp;x (m):</translation>
    </message>
    <message>
        <source>Blueprint &amp;y (m):</source>
        <translation>Bauplan &amp;y (m):</translation>
    </message>
    <message>
        <source>&amp;SLAM map x (m):</source>
        <translation>&amp;SLAM-Karte x (m):</translation>
    </message>
    <message>
        <source>SLAM &amp;map y (m):</source>
        <translation>SLAM-&amp;Karte y (m):</translation>
    </message>
</context>
<context>
    <name>cad2slam::AnchorPanel</name>
    <message>
        <source>Anchors</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>No anchors yet. Click a corner or pillar in either view, then the same place in the other.</source>
        <translation>Noch keine Anker. Eine Ecke oder einen Pfeiler in einer Ansicht anklicken, dann dieselbe Stelle in der anderen.</translation>
    </message>
    <message>
        <source>Anchors that take part, of all anchors</source>
        <translation>Anker, die mitwirken, von allen Ankern</translation>
    </message>
    <message>
        <source>Root mean square of the residuals of the anchors used</source>
        <translation>Quadratisches Mittel der Restfehler der benutzten Anker</translation>
    </message>
    <message>
        <source>Largest residual of the anchors used</source>
        <translation>Größter Restfehler der benutzten Anker</translation>
    </message>
    <message>
        <source>Middle of what each anchor would be missed by without itself: an honest guess of the error elsewhere</source>
        <translation>Mitte dessen, um wie viel jeder Anker ohne sich selbst verfehlt würde: eine ehrliche Schätzung des Fehlers anderswo</translation>
    </message>
    <message>
        <source>Used %1 of %2</source>
        <translation>Benutzt %1 von %2</translation>
    </message>
    <message>
        <source>RMS %1</source>
        <translation>Mittel (RMS) %1</translation>
    </message>
    <message>
        <source>Largest %1</source>
        <translation>Größter %1</translation>
    </message>
    <message>
        <source>Without-it median %1</source>
        <translation>Median ohne Anker %1</translation>
    </message>
</context>
<context>
    <name>cad2slam::AnchorTableModel</name>
    <message>
        <source>○ Off; the limits are in the settings</source>
        <translation>○ Aus; die Grenzen stehen in den Einstellungen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>look</source>
        <translation>ansehen</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>The point is on a corner that was found in the image</source>
        <translation>Der Punkt liegt auf einer Ecke, die im Bild gefunden wurde</translation>
    </message>
    <message>
        <source>snapped</source>
        <translation>eingerastet</translation>
    </message>
    <message>
        <source>Without anchor %1 the alignment would be off by %2 here</source>
        <translation>Ohne Anker %1 läge die Ausrichtung hier %2 daneben</translation>
    </message>
    <message>
        <source>Not used: the other anchors put this place %1 from where you clicked</source>
        <translation>Nicht benutzt: die anderen Anker legen diese Stelle %1 neben den Klick</translation>
    </message>
    <message>
        <source>The alignment puts this place %1 from where you clicked</source>
        <translation>Die Ausrichtung legt diese Stelle %1 neben den Klick</translation>
    </message>
    <message>
        <source>anchor %1, used</source>
        <translation>Anker %1, benutzt</translation>
    </message>
    <message>
        <source>anchor %1, not used</source>
        <translation>Anker %1, nicht benutzt</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Blueprint x (m)</source>
        <translation>Bauplan x (m)</translation>
    </message>
    <message>
        <source>Blueprint y (m)</source>
        <translation>Bauplan y (m)</translation>
    </message>
    <message>
        <source>SLAM map x (m)</source>
        <translation>Karte x (m)</translation>
    </message>
    <message>
        <source>SLAM map y (m)</source>
        <translation>Karte y (m)</translation>
    </message>
    <message>
        <source>Residual (cm)</source>
        <translation>Restfehler (cm)</translation>
    </message>
    <message>
        <source>Without it (cm)</source>
        <translation>Ohne ihn (cm)</translation>
    </message>
    <message>
        <source>Flag</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Whether the anchor takes part; one that does not is kept as a check (X)</source>
        <translation>Ob der Anker mitwirkt; einer, der es nicht tut, bleibt als Kontrolle (X)</translation>
    </message>
    <message>
        <source>Distance between where the alignment puts the anchor and where you clicked</source>
        <translation>Abstand zwischen der Stelle, an die die Ausrichtung den Anker legt, und dem Klick</translation>
    </message>
    <message>
        <source>How far off the alignment would be here without this anchor (from 4 anchors on)</source>
        <translation>Wie weit die Ausrichtung hier ohne diesen Anker danebenläge (ab 4 Ankern)</translation>
    </message>
    <message>
        <source>In the image at %1 px</source>
        <translation>Im Bild bei %1 px</translation>
    </message>
    <message>
        <source>%1 (%2 px)</source>
        <translation>%1 (%2 px)</translation>
    </message>
</context>
<context>
    <name>cad2slam::Autosave</name>
    <message>
        <source>%1 cannot be created, so nothing is autosaved</source>
        <translation>%1 kann nicht angelegt werden, darum wird nichts automatisch gesichert</translation>
    </message>
</context>
<context>
    <name>cad2slam::CheatSheet</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Place one half of an anchor; the click in the other view completes it</source>
        <translation>Eine Hälfte eines Ankers setzen; der Klick in der anderen Ansicht vollendet ihn</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Take the predicted place for the other half</source>
        <translation>Die vorhergesagte Stelle für die andere Hälfte nehmen</translation>
    </message>
    <message>
        <source>Esc, right click</source>
        <translation>Esc, Rechtsklick</translation>
    </message>
    <message>
        <source>Drop the half that waits; never closes the window</source>
        <translation>Die wartende Hälfte fallen lassen; schließt nie das Fenster</translation>
    </message>
    <message>
        <source>Drag an anchor</source>
        <translation>Einen Anker ziehen</translation>
    </message>
    <message>
        <source>Move it; Esc while dragging puts it back</source>
        <translation>Ihn verschieben; Esc beim Ziehen legt ihn zurück</translation>
    </message>
    <message>
        <source>Drag elsewhere, middle button, Space + drag</source>
        <translation>Anderswo ziehen, mittlere Taste, Leertaste + ziehen</translation>
    </message>
    <message>
        <source>Move the map</source>
        <translation>Die Karte verschieben</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>Am Zeiger vergrößern</translation>
    </message>
    <message>
        <source>Shift + wheel, drag the compass</source>
        <translation>Umschalt + Rad, am Kompass ziehen</translation>
    </message>
    <message>
        <source>Turn the map; a click on the compass turns it back</source>
        <translation>Die Karte drehen; ein Klick auf den Kompass dreht sie zurück</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Nudge the selected anchor by 1 pixel; Shift 10, Ctrl 0.1</source>
        <translation>Den ausgewählten Anker um 1 Pixel schieben; Umschalt 10, Strg 0,1</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Nudge the other half</source>
        <translation>Die andere Hälfte schieben</translation>
    </message>
    <message>
        <source>Ctrl + click</source>
        <translation>Strg + Klick</translation>
    </message>
    <message>
        <source>Select several anchors</source>
        <translation>Mehrere Anker auswählen</translation>
    </message>
    <message>
        <source>Hold Z</source>
        <translation>Z halten</translation>
    </message>
    <message>
        <source>Loupe under the cursor</source>
        <translation>Lupe unter dem Zeiger</translation>
    </message>
    <message>
        <source>Hold Alt</source>
        <translation>Alt halten</translation>
    </message>
    <message>
        <source>Suspend snapping</source>
        <translation>Einrasten aussetzen</translation>
    </message>
    <message>
        <source>Hold B</source>
        <translation>B halten</translation>
    </message>
    <message>
        <source>Blink the preview</source>
        <translation>Die Vorschau blinken lassen</translation>
    </message>
    <message>
        <source>Space in the table</source>
        <translation>Leertaste in der Tabelle</translation>
    </message>
    <message>
        <source>Use the anchor or not</source>
        <translation>Den Anker benutzen oder nicht</translation>
    </message>
    <message>
        <source>In the views</source>
        <translation>In den Ansichten</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
</context>
<context>
    <name>cad2slam::CoordinateDelegate</name>
    <message>
        <source>This is not a number of metres</source>
        <translation>Das ist keine Zahl in Metern</translation>
    </message>
</context>
<context>
    <name>cad2slam::DiagnosisMessages</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Rescale blueprint</source>
        <translation>Bauplan skalieren</translation>
    </message>
    <message>
        <source>Disable %1</source>
        <translation>%1 abschalten</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 share a blueprint point but are %3 apart on the SLAM map</source>
        <translation>Anker %1 und %2 teilen einen Punkt im Bauplan, liegen aber in der SLAM-Karte %3 auseinander</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 share a point of the SLAM map but are %3 apart in the blueprint</source>
        <translation>Anker %1 und %2 teilen einen Punkt in der SLAM-Karte, liegen aber im Bauplan %3 auseinander</translation>
    </message>
    <message>
        <source>The blueprint looks mirrored: mirrored, the anchors would be off by %1 instead of %2</source>
        <translation>Der Bauplan sieht gespiegelt aus: gespiegelt lägen die Anker %1 statt %2 daneben</translation>
    </message>
    <message>
        <source>Mirror blueprint</source>
        <translation>Bauplan spiegeln</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 look swapped: exchanged, the error falls from %3 to %4</source>
        <translation>Anker %1 und %2 sehen vertauscht aus: getauscht sinkt der Fehler von %3 auf %4</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>%1 und %2 tauschen</translation>
    </message>
    <message>
        <source>Anchor %1 does not fit the others: they put it %2 away</source>
        <translation>Anker %1 passt nicht zu den anderen: sie legen ihn %2 daneben</translation>
    </message>
    <message>
        <source>The mesh folds near anchors %1 and %2: they pull against each other</source>
        <translation>Das Netz faltet sich bei den Ankern %1 und %2: sie ziehen gegeneinander</translation>
    </message>
    <message>
        <source>The mesh folds over itself: some anchors pull against each other</source>
        <translation>Das Netz faltet sich: einige Anker ziehen gegeneinander</translation>
    </message>
    <message>
        <source>The blueprint is %1 % too small for the SLAM map: its scale is wrong</source>
        <translation>Der Bauplan ist %1 % zu klein für die SLAM-Karte: sein Maßstab ist falsch</translation>
    </message>
    <message>
        <source>The blueprint is %1 % too large for the SLAM map: its scale is wrong</source>
        <translation>Der Bauplan ist %1 % zu groß für die SLAM-Karte: sein Maßstab ist falsch</translation>
    </message>
    <message>
        <source>Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %): check the scale of the blueprint</source>
        <translation>Bauplan %1 m, SLAM-Karte %2 m zwischen den zwei Ankern (%3 %): Maßstab des Bauplans prüfen</translation>
    </message>
    <message>
        <source>Anchors %1 and %2 are only %3 apart: add one far away, or the rotation stays a guess</source>
        <translation>Anker %1 und %2 liegen nur %3 auseinander: einen weit weg setzen, sonst bleibt die Drehung geraten</translation>
    </message>
    <message>
        <source>All anchors lie on one line: add one beside it, or the other direction stays a guess</source>
        <translation>Alle Anker liegen auf einer Linie: einen daneben setzen, sonst bleibt die andere Richtung geraten</translation>
    </message>
    <message>
        <source>All anchors are in one room: the rest of the building is a guess</source>
        <translation>Alle Anker sind in einem Raum: der Rest des Gebäudes ist geraten</translation>
    </message>
    <message>
        <source>%1 of %2 rooms have no anchor yet</source>
        <translation>%1 von %2 Räumen haben noch keinen Anker</translation>
    </message>
    <message>
        <source>A plain turn, shift and scale is enough here (%1 off in the middle): this SLAM map is not bent</source>
        <translation>Drehung, Verschiebung und Maßstab genügen hier (in der Mitte %1 daneben): diese SLAM-Karte ist nicht verbogen</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie beside the blueprint: %1</source>
        <translation>
            <numerusform>%n Anker liegt neben dem Bauplan: %1</numerusform>
            <numerusform>%n Anker liegen neben dem Bauplan: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie beside the SLAM map: %1</source>
        <translation>
            <numerusform>%n Anker liegt neben der SLAM-Karte: %1</numerusform>
            <numerusform>%n Anker liegen neben der SLAM-Karte: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Abschalten</translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie where the blueprint shows neither floor nor wall: %1</source>
        <translation>
            <numerusform>%n Anker liegt, wo der Bauplan weder Boden noch Wand zeigt: %1</numerusform>
            <numerusform>%n Anker liegen, wo der Bauplan weder Boden noch Wand zeigt: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie where the SLAM map shows neither floor nor wall: %1</source>
        <translation>
            <numerusform>%n Anker liegt, wo die SLAM-Karte weder Boden noch Wand zeigt: %1</numerusform>
            <numerusform>%n Anker liegen, wo die SLAM-Karte weder Boden noch Wand zeigt: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Show a good place</source>
        <translation>Gute Stelle zeigen</translation>
    </message>
    <message>
        <source>Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %): the scale of the blueprint fits</source>
        <translation>Bauplan %1 m, SLAM-Karte %2 m zwischen den zwei Ankern (%3 %): der Maßstab des Bauplans passt</translation>
    </message>
    <message>
        <source>The anchors do not predict each other: without itself, one is typically %1 off. Some are misplaced, or more are needed between them</source>
        <translation>Die Anker sagen einander nicht voraus: ohne sich selbst liegt einer meist %1 daneben. Einige sitzen falsch, oder dazwischen fehlen welche</translation>
    </message>
    <message>
        <source>After half a turn the anchors would fit as well: make sure that the SLAM map is the right way round, and add an anchor that has none opposite</source>
        <translation>Nach einer halben Drehung würden die Anker genauso passen: prüfen Sie, ob die SLAM-Karte richtig herum liegt, und setzen Sie einen Anker, dem keiner gegenüberliegt</translation>
    </message>
    <message>
        <source>This SLAM map is %1 % too large: %2 agrees with the blueprint</source>
        <translation>Diese SLAM-Karte ist %1 % zu groß: %2 stimmt mit dem Bauplan überein</translation>
    </message>
    <message>
        <source>This SLAM map is %1 % too small: %2 agrees with the blueprint</source>
        <translation>Diese SLAM-Karte ist %1 % zu klein: %2 stimmt mit dem Bauplan überein</translation>
    </message>
    <message>
        <source>Blueprint %1 m, SLAM map %2 m between the two anchors (%3 %), but %4 agrees with the blueprint: check the two anchors, or this SLAM map is not to scale</source>
        <translation>Bauplan %1 m, SLAM-Karte %2 m zwischen den beiden Ankern (%3 %), aber %4 stimmt mit dem Bauplan überein: prüfen Sie die beiden Anker, oder diese SLAM-Karte ist nicht maßstäblich</translation>
    </message>
</context>
<context>
    <name>cad2slam::ExportDialog</name>
    <message>
        <source>Also write the blueprint as a &amp;map in the robot's frame (YAML and PNG)</source>
        <translation>Auch den Bauplan als &amp;Karte im Koordinatensystem des Roboters schreiben (YAML und PNG)</translation>
    </message>
    <message>
        <source>&amp;Solve again</source>
        <translation>Noch einmal &amp;lösen</translation>
    </message>
    <message>
        <source>Export projector</source>
        <translation>Projektor exportieren</translation>
    </message>
    <message>
        <source>There is nothing to export yet</source>
        <translation>Es gibt noch nichts zu exportieren</translation>
    </message>
    <message>
        <source>The projector can be written, but look at this first</source>
        <translation>Der Projektor kann geschrieben werden, aber sehen Sie sich dies zuerst an</translation>
    </message>
    <message>
        <source>Ready to export</source>
        <translation>Bereit zum Export</translation>
    </message>
    <message>
        <source>Export &amp;anyway...</source>
        <translation>Trot&amp;zdem exportieren...</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportieren...</translation>
    </message>
    <message>
        <source>The warnings are written into the file.</source>
        <translation>Die Warnungen werden in die Datei geschrieben.</translation>
    </message>
</context>
<context>
    <name>cad2slam::Exports</name>
    <message>
        <source>The blueprint as a map is in %1</source>
        <translation>Der Bauplan als Karte steht in %1</translation>
    </message>
    <message>
        <source>Drawing the blueprint as a map…</source>
        <translation>Der Bauplan wird als Karte gezeichnet…</translation>
    </message>
    <message>
        <source>Whether it fits the images of this project is not known</source>
        <translation>Ob er zu den Bildern dieses Projekts passt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>It was made from the images that are shown here</source>
        <translation>Er wurde aus den Bildern gemacht, die hier gezeigt werden</translation>
    </message>
    <message>
        <source>To SLAM map &quot;%1&quot;: %2 nodes, %3 anchors; from project %4, %5, by %6</source>
        <translation>Zur SLAM-Karte „%1“: %2 Knoten, %3 Anker; aus Projekt %4, %5, von %6</translation>
    </message>
    <message>
        <source>The last solve was stopped, so there is nothing current to export</source>
        <translation>Das letzte Lösen wurde angehalten, darum gibt es nichts Aktuelles zu exportieren</translation>
    </message>
    <message>
        <source>An image is missing, or still being read</source>
        <translation>Ein Bild fehlt oder wird noch gelesen</translation>
    </message>
    <message>
        <source>There is no alignment yet: place anchors first</source>
        <translation>Es gibt noch keine Ausrichtung: zuerst Anker setzen</translation>
    </message>
    <message>
        <source>The alignment is still being computed: wait for the green chip</source>
        <translation>Die Ausrichtung wird noch berechnet: auf das grüne Feld warten</translation>
    </message>
    <message>
        <source>The last solve failed, so there is nothing current to export</source>
        <translation>Das letzte Lösen schlug fehl, darum gibt es nichts Aktuelles zu exportieren</translation>
    </message>
    <message>
        <source>Only %1 anchors are used: the map is not bent to fit; 4 or more are needed for checked results</source>
        <translation>Nur %1 Anker werden benutzt: die Karte wird nicht verbogen; 4 oder mehr braucht es für geprüfte Ergebnisse</translation>
    </message>
    <message>
        <source>%1 anchors are used, RMS of the residuals %2</source>
        <translation>%1 Anker werden benutzt, quadratisches Mittel der Restfehler %2</translation>
    </message>
    <message>
        <source>These anchors fit badly: %1</source>
        <translation>Diese Anker passen schlecht: %1</translation>
    </message>
    <message>
        <source>The mesh folds over itself in %1 places: no answer is given there</source>
        <translation>Das Netz faltet sich an %1 Stellen: dort gibt es keine Antwort</translation>
    </message>
    <message>
        <source>The mesh does not fold</source>
        <translation>Das Netz faltet sich nicht</translation>
    </message>
    <message>
        <source>The optimisation stopped before it had converged</source>
        <translation>Die Optimierung hielt an, bevor sie fertig war</translation>
    </message>
    <message>
        <source>One half anchor is still waiting for its counterpart and is left out</source>
        <translation>Ein halber Anker wartet noch auf sein Gegenstück und bleibt weg</translation>
    </message>
    <message>
        <source>Choose a SLAM map first: anchors belong to one</source>
        <translation>Zuerst eine SLAM-Karte wählen: Anker gehören zu einer</translation>
    </message>
    <message numerus="yes">
        <source>import %n anchor(s)</source>
        <translation>
            <numerusform>%n Anker importieren</numerusform>
            <numerusform>%n Anker importieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) imported</source>
        <translation>
            <numerusform>%n Anker importiert</numerusform>
            <numerusform>%n Anker importiert</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Weggelassen: %1</translation>
    </message>
    <message numerus="yes">
        <source> and %n more</source>
        <translation>
            <numerusform> und %n weitere</numerusform>
            <numerusform> und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Anchors written to %1</source>
        <translation>Anker nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Projector written to %1, read again and compared at %2 places</source>
        <translation>Projektor nach %1 geschrieben, wieder gelesen und an %2 Stellen verglichen</translation>
    </message>
    <message>
        <source>an unknown date</source>
        <translation>an einem unbekannten Tag</translation>
    </message>
    <message>
        <source>(not saved)</source>
        <translation>(nicht gespeichert)</translation>
    </message>
    <message>
        <source>Exported in spite of: %1</source>
        <translation>Exportiert trotz: %1</translation>
    </message>
    <message>
        <source>Its blueprint is not the image of this project</source>
        <translation>Sein Bauplan ist nicht das Bild dieses Projekts</translation>
    </message>
    <message>
        <source>Its SLAM map is not the one being edited</source>
        <translation>Seine SLAM-Karte ist nicht die bearbeitete</translation>
    </message>
    <message>
        <source>Import anchors</source>
        <translation>Anker importieren</translation>
    </message>
    <message>
        <source>Export anchors</source>
        <translation>Anker exportieren</translation>
    </message>
    <message>
        <source>Anchors (*.csv)</source>
        <translation>Anker (*.csv)</translation>
    </message>
    <message>
        <source>Export projector</source>
        <translation>Projektor exportieren</translation>
    </message>
    <message>
        <source>Projectors (*.c2s)</source>
        <translation>Projektoren (*.c2s)</translation>
    </message>
    <message>
        <source>Inspect a projector</source>
        <translation>Projektor ansehen</translation>
    </message>
    <message>
        <source>Projectors (*.c2s);;All files (*)</source>
        <translation>Projektoren (*.c2s);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>SHA-256 of the images: blueprint %1, SLAM map %2</source>
        <translation>SHA-256 der Bilder: Bauplan %1, SLAM-Karte %2</translation>
    </message>
    <message>
        <source>Solving the alignment from nothing…</source>
        <translation>Die Ausrichtung wird von Grund auf berechnet …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>read as the SLAM map bent onto the blueprint</source>
        <translation>gelesen als SLAM-Karte, die auf den Bauplan gebogen wurde</translation>
    </message>
    <message>
        <source>read as the blueprint bent onto the SLAM map</source>
        <translation>gelesen als Bauplan, der auf die SLAM-Karte gebogen wurde</translation>
    </message>
    <message>
        <source>Anchors (*.csv *.txt *.data *.points);;All files (*)</source>
        <translation>Anker (*.csv *.txt *.data *.points);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The blueprint is not the image this project was made with</source>
        <translation>Der Bauplan ist nicht das Bild, mit dem dieses Projekt gemacht wurde</translation>
    </message>
    <message>
        <source>The SLAM map is not the image this project was made with</source>
        <translation>Die SLAM-Karte ist nicht das Bild, mit dem dieses Projekt gemacht wurde</translation>
    </message>
    <message>
        <source>Without itself, an anchor is typically %1 off; %2 anchors are used, RMS of the residuals %3</source>
        <translation>Ohne sich selbst liegt ein Anker meist %1 daneben; %2 Anker werden benutzt, quadratisches Mittel der Restfehler %3</translation>
    </message>
    <message>
        <source>The project has changes that are not saved</source>
        <translation>Das Projekt hat Änderungen, die nicht gespeichert sind</translation>
    </message>
</context>
<context>
    <name>cad2slam::MainWindow</name>
    <message>
        <source>Blueprint</source>
        <translation>Bauplan</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>SLAM-Karte</translation>
    </message>
    <message>
        <source>SLAM map being edited</source>
        <translation>Bearbeitete SLAM-Karte</translation>
    </message>
    <message>
        <source>SLAM map being edited; each has its own anchors</source>
        <translation>Bearbeitete SLAM-Karte; jede hat ihre eigenen Anker</translation>
    </message>
    <message>
        <source>Anchors</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Rename SLAM map</source>
        <translation>SLAM-Karte umbenennen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>There is already a SLAM map %1</source>
        <translation>Es gibt schon eine SLAM-Karte %1</translation>
    </message>
    <message>
        <source>What you see is the last good result</source>
        <translation>Zu sehen ist das letzte gute Ergebnis</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>%1  x %2 m  y %3 m   pixel %4</source>
        <translation>%1  x %2 m  y %3 m   Pixel %4</translation>
    </message>
    <message>
        <source>Drop the blueprint here, or click to choose it:
a map YAML, PNG, JPG, PGM or TIFF</source>
        <translation>Bauplan hier ablegen oder zum Auswählen klicken:
Karten-YAML, PNG, JPG, PGM oder TIFF</translation>
    </message>
    <message>
        <source>Drop the SLAM map here, or click to choose it:
a map YAML, PGM, PNG or TIFF</source>
        <translation>SLAM-Karte hier ablegen oder zum Auswählen klicken:
Karten-YAML, PGM, PNG oder TIFF</translation>
    </message>
    <message>
        <source>Loading...</source>
        <translation>Lädt...</translation>
    </message>
    <message>
        <source>This image cannot be shown: see the message above</source>
        <translation>Dieses Bild kann nicht gezeigt werden: siehe Meldung oben</translation>
    </message>
    <message>
        <source>solving, step %1</source>
        <translation>löst, Schritt %1</translation>
    </message>
</context>
<context>
    <name>cad2slam::MapView</name>
    <message>
        <source>Map view</source>
        <translation>Kartenansicht</translation>
    </message>
    <message>
        <source>Residuals drawn %1 times as long</source>
        <translation>Restfehler %1-mal so lang gezeichnet</translation>
    </message>
    <message>
        <source>Reading the image, %1 %</source>
        <translation>Das Bild wird gelesen, %1 %</translation>
    </message>
</context>
<context>
    <name>cad2slam::MessageBar</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>Weniger zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n more message(s)</source>
        <translation>
            <numerusform>%n weitere Meldung</numerusform>
            <numerusform>%n weitere Meldungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cad2slam::MessageRow</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewLegend</name>
    <message>
        <source>%1 %</source>
        <comment>per cent</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Mesh: length against rest</source>
        <translation>Netz: Länge gegen Ruhelänge</translation>
    </message>
    <message>
        <source>crosses: the mesh folds</source>
        <translation>Kreuze: das Netz faltet sich</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewPanel</name>
    <message>
        <source>Overlay</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>Two inks</source>
        <translation>Zwei Tinten</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>Wischen</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Blinken</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Linse</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Local scale</source>
        <translation>Örtlicher Maßstab</translation>
    </message>
    <message>
        <source>Local turn</source>
        <translation>Örtliche Drehung</translation>
    </message>
    <message>
        <source>All SLAM maps</source>
        <translation>Alle SLAM-Karten</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How the maps are compared (O)</source>
        <translation>Wie die Karten verglichen werden (O)</translation>
    </message>
    <message>
        <source>Preview mode</source>
        <translation>Art der Vorschau</translation>
    </message>
    <message>
        <source>How opaque the upper map is ([ and ])</source>
        <translation>Wie deckend die obere Karte ist ([ und ])</translation>
    </message>
    <message>
        <source>Which map lies below (Shift+O)</source>
        <translation>Welche Karte unten liegt (Umschalt+O)</translation>
    </message>
    <message>
        <source>Blink by itself</source>
        <translation>Von selbst blinken</translation>
    </message>
    <message>
        <source>Change between the maps three times a second</source>
        <translation>Dreimal in der Sekunde zwischen den Karten wechseln</translation>
    </message>
    <message>
        <source>Show the whole map (F)</source>
        <translation>Die ganze Karte zeigen (F)</translation>
    </message>
    <message>
        <source>SLAM map on blueprint</source>
        <translation>SLAM-Karte auf Bauplan</translation>
    </message>
    <message>
        <source>Blueprint on SLAM map</source>
        <translation>Bauplan auf SLAM-Karte</translation>
    </message>
    <message>
        <source>Distance to anchors</source>
        <translation>Abstand zu Ankern</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewView</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Overlay, %1 %</source>
        <translation>Überlagerung, %1 %</translation>
    </message>
    <message>
        <source>Two inks</source>
        <translation>Zwei Tinten</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>Wischen</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Blinken</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Linse</translation>
    </message>
    <message>
        <source>Local scale against the mean</source>
        <translation>Örtlicher Maßstab gegen das Mittel</translation>
    </message>
    <message>
        <source>Local turn against the mean</source>
        <translation>Örtliche Drehung gegen das Mittel</translation>
    </message>
    <message>
        <source>All SLAM maps</source>
        <translation>Alle SLAM-Karten</translation>
    </message>
    <message>
        <source>[ and ] change it, hold B to hide it</source>
        <translation>[ und ] ändern sie, B halten blendet sie aus</translation>
    </message>
    <message>
        <source>Drag the bar</source>
        <translation>Den Balken ziehen</translation>
    </message>
    <message>
        <source>Hold B for the other map</source>
        <translation>B halten für die andere Karte</translation>
    </message>
    <message>
        <source>Dark: both agree</source>
        <translation>Dunkel: beide stimmen überein</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>links: %1</translation>
    </message>
    <message>
        <source>right: %1</source>
        <translation>rechts: %1</translation>
    </message>
    <message>
        <source>around: %1</source>
        <translation>außen: %1</translation>
    </message>
    <message>
        <source>in the lens: %1</source>
        <translation>in der Linse: %1</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>worth a look</source>
        <translation>ansehen</translation>
    </message>
    <message>
        <source>probably wrong</source>
        <translation>vermutlich falsch</translation>
    </message>
    <message>
        <source>black: the mesh folds</source>
        <translation>schwarz: das Netz faltet sich</translation>
    </message>
    <message>
        <source>°</source>
        <comment>degrees</comment>
        <translation>°</translation>
    </message>
    <message>
        <source> %</source>
        <comment>per cent</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>Residuals, %1 times as long</source>
        <translation>Restfehler, %1-mal so lang</translation>
    </message>
    <message>
        <source>From the projected to the clicked place</source>
        <translation>Von der projizierten zur geklickten Stelle</translation>
    </message>
    <message>
        <source>Distance to the nearest anchor</source>
        <translation>Abstand zum nächsten Anker</translation>
    </message>
    <message>
        <source>Anchors help most where it is red</source>
        <translation>Rot: hier hilft ein Anker am meisten</translation>
    </message>
    <message>
        <source> m</source>
        <comment>metres</comment>
        <translation> m</translation>
    </message>
</context>
<context>
    <name>cad2slam::PreviewWiring</name>
    <message>
        <source>Load a blueprint and a SLAM map to see them over each other</source>
        <translation>Bauplan und SLAM-Karte laden, um sie übereinander zu sehen</translation>
    </message>
    <message>
        <source>Load a blueprint and a SLAM map first</source>
        <translation>Zuerst Bauplan und SLAM-Karte laden</translation>
    </message>
    <message>
        <source>Nothing to lay over it yet: place an anchor in both views</source>
        <translation>Noch nichts zu überlagern: einen Anker in beiden Ansichten setzen</translation>
    </message>
    <message>
        <source>Solving...</source>
        <translation>Löst...</translation>
    </message>
    <message>
        <source>Not current: the last solve failed, this is the result before it</source>
        <translation>Nicht aktuell: das letzte Lösen schlug fehl, dies ist das Ergebnis davor</translation>
    </message>
    <message>
        <source>Not current: the last solve was stopped</source>
        <translation>Nicht aktuell: das letzte Lösen wurde angehalten</translation>
    </message>
    <message>
        <source>Rough: one anchor says nothing of the turn</source>
        <translation>Grob: ein Anker sagt nichts über die Drehung</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Bauplan</translation>
    </message>
    <message>
        <source>%1 (no anchors)</source>
        <translation>%1 (keine Anker)</translation>
    </message>
    <message>
        <source>%1 (solving...)</source>
        <translation>%1 (wird gelöst...)</translation>
    </message>
    <message>
        <source>%1 (cannot be solved)</source>
        <translation>%1 (nicht lösbar)</translation>
    </message>
    <message>
        <source>%1 (stopped)</source>
        <translation>%1 (angehalten)</translation>
    </message>
    <message>
        <source>Loading the images...</source>
        <translation>Bilder werden geladen...</translation>
    </message>
</context>
<context>
    <name>cad2slam::ProjectFiles</name>
    <message>
        <source>Project changed on disk</source>
        <translation>Projekt auf der Festplatte geändert</translation>
    </message>
    <message>
        <source>%1 was saved by another program after it was opened here.</source>
        <translation>%1 wurde von einem anderen Programm gespeichert, nachdem es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>To replace it loses what was done there.</source>
        <translation>Wird es ersetzt, geht verloren, was dort getan wurde.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>One anchor has only one half: click its counterpart, or press Esc to drop it</source>
        <translation>Ein Anker hat nur eine Hälfte: sein Gegenstück anklicken oder mit Esc fallen lassen</translation>
    </message>
    <message>
        <source>Save elsewhere...</source>
        <translation>Anderswo speichern...</translation>
    </message>
    <message>
        <source>Saved, with one half of an anchor still waiting for its counterpart</source>
        <translation>Gespeichert, mit einer Ankerhälfte, die noch auf ihr Gegenstück wartet</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Projects (*.c2sproj);;All files (*)</source>
        <translation>Projekte (*.c2sproj);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Projects (*.c2sproj)</source>
        <translation>Projekte (*.c2sproj)</translation>
    </message>
    <message>
        <source>Choose the blueprint</source>
        <translation>Bauplan wählen</translation>
    </message>
    <message>
        <source>Add a SLAM map</source>
        <translation>SLAM-Karte hinzufügen</translation>
    </message>
    <message>
        <source>Maps and images (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.tif *.tiff *.bmp);;All files (*)</source>
        <translation>Karten und Bilder (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.tif *.tiff *.bmp);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The project has changes that are not saved.</source>
        <translation>Das Projekt hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Save them before it is closed?</source>
        <translation>Vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>Find it...</source>
        <translation>Suchen...</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Wo ist %1?</translation>
    </message>
    <message>
        <source>Use this one</source>
        <translation>Dieses benutzen</translation>
    </message>
</context>
<context>
    <name>cad2slam::RasterStore</name>
    <message>
        <source>%1 is not the image this project was made with; check that the anchors still fit</source>
        <translation>%1 ist nicht das Bild, mit dem dieses Projekt gemacht wurde; prüfen, ob die Anker noch passen</translation>
    </message>
</context>
<context>
    <name>cad2slam::Recovery</name>
    <message>
        <source>Autosave does not work: %1</source>
        <translation>Die automatische Sicherung geht nicht: %1</translation>
    </message>
    <message>
        <source>a project that was never saved</source>
        <translation>ein Projekt, das nie gespeichert wurde</translation>
    </message>
    <message>
        <source>The program ended unexpectedly; %1 was last edited %2</source>
        <translation>Das Programm endete unerwartet; %1 wurde zuletzt am %2 bearbeitet</translation>
    </message>
    <message>
        <source>What a program that ended unexpectedly has left of %1 cannot be read: %2</source>
        <translation>Was ein unerwartet beendetes Programm von %1 hinterlassen hat, kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>It was saved again %1, so what is recovered will be a project of its own</source>
        <translation>Es wurde am %1 noch einmal gespeichert; was wiederhergestellt wird, wird deshalb ein eigenes Projekt</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Images: %1; anchors: %2</source>
        <translation>Bilder: %1; Anker: %2</translation>
    </message>
</context>
<context>
    <name>cad2slam::ScaleDialog</name>
    <message>
        <source>Scale of the blueprint</source>
        <translation>Maßstab des Bauplans</translation>
    </message>
    <message>
        <source>Scale of the SLAM map</source>
        <translation>Maßstab der SLAM-Karte</translation>
    </message>
    <message>
        <source>%1 does not tell its scale. Type it, or click both ends of something whose length you know and type that length.</source>
        <translation>%1 sagt nichts über seinen Maßstab. Geben Sie ihn ein, oder klicken Sie beide Enden von etwas an, dessen Länge Sie kennen, und geben Sie diese Länge ein.</translation>
    </message>
    <message>
        <source>Line drawn:</source>
        <translation>Gezeichnete Linie:</translation>
    </message>
    <message>
        <source>Its &amp;length (m):</source>
        <translation>Ihre &amp;Länge (m):</translation>
    </message>
    <message>
        <source>&amp;Metres for each pixel:</source>
        <translation>&amp;Meter je Pixel:</translation>
    </message>
    <message>
        <source>Size of the picture:</source>
        <translation>Größe des Bildes:</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>click one end</source>
        <translation>ein Ende anklicken</translation>
    </message>
    <message>
        <source>click the other end</source>
        <translation>das andere Ende anklicken</translation>
    </message>
    <message>
        <source>%1 m x %2 m at %3 m for each pixel</source>
        <translation>%1 m x %2 m bei %3 m je Pixel</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>noch nicht bekannt</translation>
    </message>
    <message>
        <source>for example %1</source>
        <translation>zum Beispiel %1</translation>
    </message>
</context>
<context>
    <name>cad2slam::SettingsDialog</name>
    <message>
        <source>An anchor is judged by the error without it, from four anchors on. The larger of a length and a number of SLAM map pixels counts. When most anchors are beyond the last limit, a message says so. These limits are kept in the project.</source>
        <translation>Ein Anker wird ab vier Ankern nach dem Fehler ohne ihn beurteilt. Es zählt das Größere aus einer Länge und einer Zahl von Pixeln der SLAM-Karte. Liegen die meisten Anker jenseits der letzten Grenze, so sagt das eine Meldung. Diese Grenzen stehen im Projekt.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Alignment</source>
        <translation>&amp;Ausrichtung</translation>
    </message>
    <message>
        <source>&amp;Limits</source>
        <translation>&amp;Grenzen</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>A&amp;ussehen</translation>
    </message>
    <message>
        <source>&amp;Defaults of the model</source>
        <translation>&amp;Vorgaben des Modells</translation>
    </message>
    <message>
        <source>Stretch: bends and stretches (recommended)</source>
        <translation>Dehnen: biegt und dehnt (empfohlen)</translation>
    </message>
    <message>
        <source>Rigid: bends only, as in the paper</source>
        <translation>Starr: biegt nur, wie in der Veröffentlichung</translation>
    </message>
    <message>
        <source>&amp;Model:</source>
        <translation>&amp;Modell:</translation>
    </message>
    <message>
        <source>The plan is to scale</source>
        <translation>Der Plan ist maßstäblich</translation>
    </message>
    <message>
        <source>Unknown: find it from the anchors</source>
        <translation>Unbekannt: aus den Ankern finden</translation>
    </message>
    <message>
        <source>A number I know</source>
        <translation>Eine Zahl, die ich kenne</translation>
    </message>
    <message>
        <source>&amp;Scale of the blueprint:</source>
        <translation>Maßstab des &amp;Bauplans:</translation>
    </message>
    <message>
        <source>SLAM metres per blueprint metre:</source>
        <translation>SLAM-Meter je Bauplanmeter:</translation>
    </message>
    <message>
        <source>1 where both are true to scale</source>
        <translation>1, wo beide maßstäblich sind</translation>
    </message>
    <message>
        <source>&amp;Cell size of the mesh (m):</source>
        <translation>&amp;Zellgröße des Netzes (m):</translation>
    </message>
    <message>
        <source>Smaller follows finer bends and takes longer</source>
        <translation>Kleiner folgt feineren Biegungen und dauert länger</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Pull of an anchor:</source>
        <translation>Zugkraft eines Ankers:</translation>
    </message>
    <message>
        <source>Larger trusts the clicks more</source>
        <translation>Größer vertraut den Klicks mehr</translation>
    </message>
    <message>
        <source>Bad anchors start at (m):</source>
        <translation>Schlechte Anker ab (m):</translation>
    </message>
    <message>
        <source>An anchor off by more than this loses its pull; empty trusts every anchor</source>
        <translation>Ein Anker, der weiter danebenliegt, verliert seine Zugkraft; leer vertraut jedem Anker</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Stiffness along an edge:</source>
        <translation>Steifigkeit längs einer Kante:</translation>
    </message>
    <message>
        <source>Stiffness across an edge:</source>
        <translation>Steifigkeit quer zu einer Kante:</translation>
    </message>
    <message>
        <source>Stiffness of bending:</source>
        <translation>Biegesteifigkeit:</translation>
    </message>
    <message>
        <source>Empty follows the size of the building</source>
        <translation>Leer folgt der Größe des Gebäudes</translation>
    </message>
    <message>
        <source>Smoothness of the stretch:</source>
        <translation>Glätte der Dehnung:</translation>
    </message>
    <message>
        <source>Resistance to stretch:</source>
        <translation>Widerstand gegen Dehnung:</translation>
    </message>
    <message>
        <source>● OK up to (m):</source>
        <translation>● OK bis (m):</translation>
    </message>
    <message>
        <source>● OK up to (pixels):</source>
        <translation>● OK bis (Pixel):</translation>
    </message>
    <message>
        <source>◆ Have a look up to (m):</source>
        <translation>◆ Ansehen bis (m):</translation>
    </message>
    <message>
        <source>◆ Have a look up to (pixels):</source>
        <translation>◆ Ansehen bis (Pixel):</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast, for sunlight</source>
        <translation>Hoher Kontrast, für die Sonne</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Farben:</translation>
    </message>
    <message>
        <source>&amp;Language (from the next start):</source>
        <translation>&amp;Sprache (ab dem nächsten Start):</translation>
    </message>
    <message>
        <source>The fields with a frame need a number above zero that a project can hold</source>
        <translation>Die umrahmten Felder brauchen eine Zahl über null, die ein Projekt aufnehmen kann</translation>
    </message>
    <message>
        <source>Automatic: what predicts the anchors best (recommended)</source>
        <translation>Automatisch: was die Anker am besten vorhersagt (empfohlen)</translation>
    </message>
    <message>
        <source>Loose: clicks that are noisier than the map is bent</source>
        <translation>Locker: Klicks, die ungenauer sind, als die Karte verbogen ist</translation>
    </message>
    <message>
        <source>Smooth: halls that bend as a whole</source>
        <translation>Glatt: Hallen, die sich als Ganzes biegen</translation>
    </message>
    <message>
        <source>Local: corridors that drifted each by themselves</source>
        <translation>Örtlich: Flure, die jeder für sich abgedriftet sind</translation>
    </message>
    <message>
        <source>The numbers below</source>
        <translation>Die Zahlen darunter</translation>
    </message>
    <message>
        <source>S&amp;tiffness:</source>
        <translation>S&amp;teifigkeit:</translation>
    </message>
</context>
<context>
    <name>cad2slam::TestPoses</name>
    <message>
        <source>%1 (extrapolated)</source>
        <translation>%1 (extrapoliert)</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Place anchors first, then the robot shows in both views</source>
        <translation>Zuerst Anker setzen, dann erscheint der Roboter in beiden Ansichten</translation>
    </message>
    <message>
        <source>The mesh folds here: there is no answer</source>
        <translation>Das Netz faltet sich hier: es gibt keine Antwort</translation>
    </message>
    <message>
        <source>There is no answer at this place</source>
        <translation>An dieser Stelle gibt es keine Antwort</translation>
    </message>
    <message>
        <source>%1SLAM map x %2 m, y %3 m, heading %4°; there and back differs by %5 mm, %6°</source>
        <translation>%1SLAM-Karte x %2 m, y %3 m, Richtung %4°; hin und zurück weicht um %5 mm, %6° ab</translation>
    </message>
    <message>
        <source>Extrapolated: </source>
        <translation>Extrapoliert: </translation>
    </message>
</context>
<context>
    <name>cad2slam::TilePyramid</name>
    <message>
        <source>The image %1 could not be read: %2</source>
        <translation>Das Bild %1 konnte nicht gelesen werden: %2</translation>
    </message>
</context>
<context>
    <name>cad2slam::Tips</name>
    <message>
        <source>O shows the next way to compare the maps; hold B to see one map alone</source>
        <translation>O zeigt die nächste Art, die Karten zu vergleichen; B gehalten zeigt eine Karte allein</translation>
    </message>
    <message>
        <source>N goes to the anchor with the largest error, and shows it in both views</source>
        <translation>N geht zum Anker mit dem größten Fehler und zeigt ihn in beiden Ansichten</translation>
    </message>
    <message>
        <source>R shows a robot to drag: where it is in one map, and where in the other</source>
        <translation>R zeigt einen Roboter zum Ziehen: wo er in der einen Karte ist und wo in der anderen</translation>
    </message>
    <message>
        <source>F1 shows all keys</source>
        <translation>F1 zeigt alle Tasten</translation>
    </message>
    <message>
        <source>Tip: %1</source>
        <translation>Tipp: %1</translation>
    </message>
    <message>
        <source>No more tips</source>
        <translation>Keine Tipps mehr</translation>
    </message>
    <message>
        <source>Arrow keys move the selected anchor by one pixel; hold Z to see it four times larger</source>
        <translation>Pfeiltasten schieben den gewählten Anker um ein Pixel; Z gehalten vergrößert vierfach</translation>
    </message>
</context>
<context>
    <name>cad2slam::Tour</name>
    <message>
        <source>The sample building is not installed; drop your own two maps into the views</source>
        <translation>Das Beispielgebäude ist nicht installiert; ziehen Sie Ihre eigenen zwei Karten in die Ansichten</translation>
    </message>
    <message>
        <source>On the left the plan of an office, on the right what a robot has mapped. Click a corner of a room in the plan; the wheel zooms, dragging moves</source>
        <translation>Links der Plan eines Büros, rechts, was ein Roboter kartiert hat. Klicken Sie eine Raumecke im Plan an; das Rad vergrößert, Ziehen verschiebt</translation>
    </message>
    <message>
        <source>Now find the same corner on the right and click it. Holding Z magnifies</source>
        <translation>Jetzt dieselbe Ecke rechts finden und anklicken. Z gedrückt halten vergrößert</translation>
    </message>
    <message>
        <source>That is an anchor. Make a second one far away from it</source>
        <translation>Das ist ein Anker. Setzen Sie einen zweiten weit weg davon</translation>
    </message>
    <message>
        <source>From four anchors on each is checked by the others: see &quot;Without it&quot; in the table. The preview shows both maps together, O changes how</source>
        <translation>Ab vier Ankern wird jeder von den anderen geprüft: siehe „Ohne ihn“ in der Tabelle. Die Vorschau zeigt beide Karten zusammen, O wechselt die Art</translation>
    </message>
    <message>
        <source>More anchors where the preview is off make it better; Ctrl+E writes the file for the robots</source>
        <translation>Weitere Anker, wo die Vorschau nicht passt, machen es besser; Strg+E schreibt die Datei für die Roboter</translation>
    </message>
    <message>
        <source>Step %1 of %2. %3</source>
        <translation>Schritt %1 von %2. %3</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>From now on the other half is predicted: after the first click a blue mark shows it. Enter takes it, a click elsewhere corrects it. Make four anchors</source>
        <translation>Ab jetzt wird die andere Hälfte vorhergesagt: nach dem ersten Klick zeigt sie ein blaues Zeichen. Enter nimmt sie, ein Klick woanders korrigiert sie. Vier Anker setzen</translation>
    </message>
</context>
<context>
    <name>cad2slam::ViewPair</name>
    <message>
        <source>Click the same place here (Enter accepts, Esc cancels)</source>
        <translation>Dieselbe Stelle hier anklicken (Enter nimmt an, Esc bricht ab)</translation>
    </message>
    <message>
        <source>Now click the same place here (Esc cancels)</source>
        <translation>Jetzt dieselbe Stelle hier anklicken (Esc bricht ab)</translation>
    </message>
    <message>
        <source>%1? Enter accepts</source>
        <translation>%1? Enter nimmt an</translation>
    </message>
</context>
<context>
    <name>edit</name>
    <message>
        <source>add anchor %1</source>
        <translation>Anker %1 hinzufügen</translation>
    </message>
    <message>
        <source>move anchor %1</source>
        <translation>Anker %1 verschieben</translation>
    </message>
    <message>
        <source>type coordinates of anchor %1</source>
        <translation>Koordinaten von Anker %1 eingeben</translation>
    </message>
    <message>
        <source>delete anchor %1</source>
        <translation>Anker %1 löschen</translation>
    </message>
    <message>
        <source>delete %1 anchors</source>
        <translation>%1 Anker löschen</translation>
    </message>
    <message>
        <source>use anchors</source>
        <translation>Anker benutzen</translation>
    </message>
    <message>
        <source>disable anchors</source>
        <translation>Anker abschalten</translation>
    </message>
    <message>
        <source>rename anchor %1</source>
        <translation>Anker %1 umbenennen</translation>
    </message>
    <message>
        <source>note on anchor %1</source>
        <translation>Notiz zu Anker %1</translation>
    </message>
    <message>
        <source>swap anchors %1 and %2</source>
        <translation>Anker %1 und %2 tauschen</translation>
    </message>
    <message>
        <source>SLAM map</source>
        <translation>SLAM-Karte</translation>
    </message>
    <message>
        <source>choose blueprint</source>
        <translation>Bauplan wählen</translation>
    </message>
    <message>
        <source>rescale blueprint</source>
        <translation>Bauplan skalieren</translation>
    </message>
    <message>
        <source>mirror blueprint</source>
        <translation>Bauplan spiegeln</translation>
    </message>
    <message>
        <source>change settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message>
        <source>add SLAM map</source>
        <translation>SLAM-Karte hinzufügen</translation>
    </message>
    <message>
        <source>remove SLAM map</source>
        <translation>SLAM-Karte entfernen</translation>
    </message>
    <message>
        <source>rename SLAM map</source>
        <translation>SLAM-Karte umbenennen</translation>
    </message>
    <message>
        <source>choose SLAM map</source>
        <translation>SLAM-Karte wählen</translation>
    </message>
</context>
<context>
    <name>units</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
</TS>
