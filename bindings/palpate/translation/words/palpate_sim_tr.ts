<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: BSD-3-Clause -->
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>Alarm</name>
    <message>
        <source>the tissue blew up: a position is not a number</source>
        <translation>doku patladı: bir konum sayı değil</translation>
    </message>
    <message>
        <source>the tissue blew up: a point moved %1 mm between two looks, at most %2 mm is right</source>
        <translation>doku patladı: bir nokta iki bakış arasında %1 mm yer değiştirdi, en çok %2 mm olmalı</translation>
    </message>
    <message>
        <source>the tissue blew up: its energy rose to %1 mJ, what it was given allows %2 mJ</source>
        <translation>doku patladı: enerjisi %1 mJ oldu, verilen enerji en çok %2 mJ için yeter</translation>
    </message>
    <message>
        <source>a link was stretched to %1 times its length at rest, at most %2 times is right</source>
        <translation>bir bağ durgun boyunun %1 katına gerildi, en çok %2 katı olmalı</translation>
    </message>
    <message>
        <source>a link was squeezed to %1 % of its length at rest, at least %2 % is right</source>
        <translation>bir bağ durgun boyunun %%1 kadarına sıkıştı, en az %%2 kalmalı</translation>
    </message>
    <message>
        <source>a tetrahedron was squeezed to %1 % of its volume at rest, at least %2 % is right</source>
        <translation>bir dörtyüzlü durgun hacminin %%1 kadarına sıkıştı, en az %%2 kalmalı</translation>
    </message>
    <message>
        <source>the tissue was moved by %1 mm; there a linear solid is good for %2 mm</source>
        <translation>doku %1 mm yer değiştirdi; orada doğrusal dolu cisim %2 mm için geçerlidir</translation>
    </message>
    <message>
        <source>Press less deep or more slowly.</source>
        <translation>Daha az derine ya da daha yavaş bastırın.</translation>
    </message>
    <message>
        <source>Move more slowly. If it comes again, whoever made this organ has to make it more stable.</source>
        <translation>Daha yavaş hareket edin. Yine olursa bu organı hazırlayan onu daha kararlı yapmalıdır.</translation>
    </message>
    <message>
        <source>Press less deep or more slowly, or make the organ stiffer.</source>
        <translation>Daha az derine ya da daha yavaş bastırın ya da organı sertleştirin.</translation>
    </message>
    <message>
        <source>More substeps (--substeps), softer springs (--stiffness) or a larger mass (--density) hold it together.</source>
        <translation>Daha çok alt adım (--substeps), daha yumuşak yaylar (--stiffness) ya da daha büyük kütle (--density) onu bir arada tutar.</translation>
    </message>
    <message>
        <source>The tissue needs %1 substeps a tick, at most %2 are taken: choose more (--substeps), softer springs (--stiffness) or a larger mass (--density).</source>
        <translation>Doku her tikte %1 alt adım ister, en çok %2 atılır: daha çok alt adım (--substeps), daha yumuşak yaylar (--stiffness) ya da daha büyük kütle (--density) seçin.</translation>
    </message>
    <message>
        <source>Its damping needs %1 substeps a tick, at most %2 are taken: choose less damping (--damping) or more substeps (--substeps).</source>
        <translation>Sönümü her tikte %1 alt adım ister, en çok %2 atılır: daha az sönüm (--damping) ya da daha çok alt adım (--substeps) seçin.</translation>
    </message>
    <message>
        <source>The contact stiffness of the tool needs %1 substeps a tick, at most %2 are taken: choose a lower one (--tool-stiffness) or more substeps (--substeps).</source>
        <translation>Aletin temas sertliği her tikte %1 alt adım ister, en çok %2 atılır: daha düşük bir temas sertliği (--tool-stiffness) ya da daha çok alt adım (--substeps) seçin.</translation>
    </message>
    <message>
        <source>Its pressure does it with nothing touching: choose a lower one (--pressure), or stiffer springs (--stiffness, --home).</source>
        <translation>Hiçbir şey değmeden basıncı bunu yapıyor: daha düşük bir basınç (--pressure) ya da daha sert yaylar (--stiffness, --home) seçin.</translation>
    </message>
    <message>
        <source>Press less deep, or take a solid (MSS+V), which goes deeper.</source>
        <translation>Daha az derine bastırın ya da daha derine giden dolu cismi (MSS+V) seçin.</translation>
    </message>
    <message>
        <source>a tick was given a value that it cannot use</source>
        <translation>bir adıma kullanamayacağı bir değer verildi</translation>
    </message>
    <message>
        <source>Start again. If it comes again, the device or the program that runs it is at fault.</source>
        <translation>Yeniden başlatın. Yine olursa cihazda ya da onu çalıştıran programda hata vardır.</translation>
    </message>
    <message>
        <source>Give every tick finite numbers, and the scene as build_scene returned it.</source>
        <translation>Her adıma sonlu sayılar ve build_scene'in verdiği sahneyi verin.</translation>
    </message>
    <message>
        <source>the device gave a time of %1 s, expected a finite number</source>
        <translation>cihaz %1 s zaman verdi, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave a position of %1 m, expected at most %2 m</source>
        <translation>cihaz %1 m konum verdi, en çok %2 m bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave an orientation with %1, expected finite numbers</source>
        <translation>cihaz içinde %1 olan bir yönelim verdi, sonlu sayılar bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave a velocity of %1 m/s, expected a finite number</source>
        <translation>cihaz %1 m/s hız verdi, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>the device gave a grip of %1 rad, expected a finite number</source>
        <translation>cihaz %1 rad kavrama verdi, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>a tick was asked to last %1 s, expected more than 0</source>
        <translation>bir adımın %1 s sürmesi istendi, 0'dan çok bekleniyordu</translation>
    </message>
    <message>
        <source>a tick was given scene %1, expected scene %2, which its world was made for</source>
        <translation>bir adıma %1. sahne verildi, dünyasının yapıldığı %2. sahne bekleniyordu</translation>
    </message>
    <message>
        <source>the radius of the tool became %1 m, expected more than 0</source>
        <translation>aletin yarıçapı %1 m oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the stiffness of the tool became %1 N/m³, expected more than 0</source>
        <translation>aletin sertliği %1 N/m³ oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the coupling stiffness became %1 N/m, expected more than 0</source>
        <translation>bağlaşım sertliği %1 N/m oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the largest coupling force became %1 N, expected more than 0</source>
        <translation>en büyük bağlaşım kuvveti %1 N oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>the hold stiffness became %1 N/m, expected more than 0</source>
        <translation>tutma sertliği %1 N/m oldu, 0'dan büyük olmalı</translation>
    </message>
    <message>
        <source>gravity became %1 m/s², expected a finite number</source>
        <translation>yerçekimi %1 m/s² oldu, sonlu bir sayı bekleniyordu</translation>
    </message>
    <message>
        <source>the substeps became %1, expected at least %2</source>
        <translation>alt adım sayısı %1 oldu, en az %2 olmalı</translation>
    </message>
    <message>
        <source>the most substeps became %1, expected at least %2</source>
        <translation>en çok alt adım sayısı %1 oldu, en az %2 olmalı</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>%1 bytes</source>
        <translation>%1 bayt</translation>
    </message>
    <message>
        <source>%1 bytes for so many</source>
        <translation>bu kadarı için %1 bayt</translation>
    </message>
    <message>
        <source>%1 entries</source>
        <translation>%1 girdi</translation>
    </message>
    <message>
        <source>%1 of %2 that cross others</source>
        <translation>%2 üçgenden %1 tanesi başkalarıyla kesişiyor</translation>
    </message>
    <message>
        <source>%1 triangles in %2 bytes</source>
        <translation>%2 bayt içinde %1 üçgen</translation>
    </message>
    <message>
        <source>%1 with more than two triangles</source>
        <translation>ikiden çok üçgeni olan %1 kenar</translation>
    </message>
    <message>
        <source>%1: %2, expected a serial port that takes %3 bit/s</source>
        <translation>%1: %2; beklenen: %3 bit/s hızını alan bir seri kapı</translation>
    </message>
    <message>
        <source>%1: did not take the calibration: %2</source>
        <translation>%1: kalibrasyonu kabul etmedi: %2</translation>
    </message>
    <message>
        <source>%1: found %2, expected %3</source>
        <translation>%1: bulunan: %2; beklenen: %3</translation>
    </message>
    <message>
        <source>%1: has no calibration</source>
        <translation>%1: kalibrasyonu yok</translation>
    </message>
    <message>
        <source>0 bytes</source>
        <translation>0 bayt</translation>
    </message>
    <message>
        <source>84 bytes of header, or text that begins with 'solid'</source>
        <translation>84 baytlık başlık ya da 'solid' ile başlayan metin</translation>
    </message>
    <message>
        <source>; fewer parts may do (--part)</source>
        <translation>; daha az parça yetebilir (--part)</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>aygıt başkası tarafından kullanılıyor</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>dosya zaten var</translation>
    </message>
    <message>
        <source>Inappropriate ioctl for device</source>
        <translation>bu bir seri kapı değil</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>giriş/çıkış hatası</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>bu bir klasör</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>diskte yer kalmadı</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>böyle bir aygıt yok</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>böyle bir dosya ya da klasör yok</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>bu bir klasör değil</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>izin yok</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>salt okunur dosya sistemi</translation>
    </message>
    <message>
        <source>a coordinate that is not a finite number</source>
        <translation>sonlu bir sayı olmayan bir koordinat</translation>
    </message>
    <message>
        <source>a damaged entry</source>
        <translation>bozuk bir girdi</translation>
    </message>
    <message>
        <source>a damaged zip archive (%1)</source>
        <translation>bozuk bir zip arşivi (%1)</translation>
    </message>
    <message>
        <source>a directory of too many entries</source>
        <translation>çok fazla girdisi olan bir dizin</translation>
    </message>
    <message>
        <source>a folder in which every new file is taken away</source>
        <translation>her yeni dosyanın alınıp götürüldüğü bir klasör</translation>
    </message>
    <message>
        <source>a folder that the disk does not sync (%1)</source>
        <translation>diskin eşitlemediği bir klasör (%1)</translation>
    </message>
    <message>
        <source>one that it does: the file is saved, but a loss of power may bring back what stood there before</source>
        <translation>eşitlediği bir klasör: dosya kaydedildi, ama elektrik kesilirse önceki hâli geri gelebilir</translation>
    </message>
    <message>
        <source>a reference to %1</source>
        <translation>%1 dosyasına bir gönderme</translation>
    </message>
    <message>
        <source>references to files beside the mesh or below its folder</source>
        <translation>ağın yanındaki ya da klasörünün altındaki dosyalara göndermeler</translation>
    </message>
    <message>
        <source>something other than a file</source>
        <translation>dosya olmayan bir şey</translation>
    </message>
    <message>
        <source>a file that can be written</source>
        <translation>yazılabilen bir dosya</translation>
    </message>
    <message>
        <source>a file that cannot be read</source>
        <translation>okunamayan bir dosya</translation>
    </message>
    <message>
        <source>a link or a folder</source>
        <translation>bir bağlantı ya da klasör</translation>
    </message>
    <message>
        <source>a mesh file</source>
        <translation>bir ağ dosyası</translation>
    </message>
    <message>
        <source>a mesh that can be read in that time</source>
        <translation>bu sürede okunabilen bir ağ</translation>
    </message>
    <message>
        <source>a plain file</source>
        <translation>sıradan bir dosya</translation>
    </message>
    <message>
        <source>a plain one</source>
        <translation>şifresiz bir girdi</translation>
    </message>
    <message>
        <source>a readable %1 file</source>
        <translation>okunabilir bir %1 dosyası</translation>
    </message>
    <message>
        <source>a readable STL file</source>
        <translation>okunabilir bir STL dosyası</translation>
    </message>
    <message>
        <source>a readable mesh file</source>
        <translation>okunabilir bir ağ dosyası</translation>
    </message>
    <message>
        <source>a reader that ended with code %1</source>
        <translation>%1 koduyla biten bir okuyucu</translation>
    </message>
    <message>
        <source>a reader that used up its processor time</source>
        <translation>işlemci süresini tüketen bir okuyucu</translation>
    </message>
    <message>
        <source>a surface</source>
        <translation>bir yüzey</translation>
    </message>
    <message>
        <source>a surface a tissue can be built on</source>
        <translation>üzerine doku kurulabilecek bir yüzey</translation>
    </message>
    <message>
        <source>a surface made of triangles or polygons</source>
        <translation>üçgen ya da çokgenlerden oluşan bir yüzey</translation>
    </message>
    <message>
        <source>a surface that does not cross itself%1</source>
        <translation>kendisiyle kesişmeyen bir yüzey%1</translation>
    </message>
    <message>
        <source>a surface with one side only, like a Moebius band</source>
        <translation>Möbius şeridi gibi tek yüzlü bir yüzey</translation>
    </message>
    <message>
        <source>a whole one</source>
        <translation>sağlam bir arşiv</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <translation>bir zip arşivi</translation>
    </message>
    <message>
        <source>an empty file</source>
        <translation>boş bir dosya</translation>
    </message>
    <message>
        <source>an encrypted entry</source>
        <translation>şifreli bir girdi</translation>
    </message>
    <message>
        <source>an index below %1</source>
        <translation>%1 değerinden küçük bir sıra numarası</translation>
    </message>
    <message>
        <source>an organ's surface</source>
        <translation>bir organın yüzeyi</translation>
    </message>
    <message>
        <source>answered, but not with its calibration or a report</source>
        <translation>yanıt verdi ama kalibrasyonunu ya da bir rapor göndermedi</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>en çok %1</translation>
    </message>
    <message>
        <source>at most %1 entries</source>
        <translation>en çok %1 girdi</translation>
    </message>
    <message>
        <source>at most %1%2</source>
        <translation>en çok %1%2</translation>
    </message>
    <message>
        <source>at most 1 GB</source>
        <translation>en çok 1 GB</translation>
    </message>
    <message>
        <source>at most two triangles at every edge%1</source>
        <translation>her kenarda en çok iki üçgen%1</translation>
    </message>
    <message>
        <source>both</source>
        <translation>ikisi de</translation>
    </message>
    <message>
        <source>compression method %1</source>
        <translation>sıkıştırma yöntemi %1</translation>
    </message>
    <message>
        <source>content assimp refuses (%1)</source>
        <translation>assimp'in kabul etmediği içerik (%1)</translation>
    </message>
    <message>
        <source>content still being read after %1</source>
        <translation>%1 sonra hâlâ okunan içerik</translation>
    </message>
    <message>
        <source>content that crashes the reader (%1)</source>
        <translation>okuyucuyu çökerten içerik (%1)</translation>
    </message>
    <message>
        <source>damaged bytes</source>
        <translation>bozuk baytlar</translation>
    </message>
    <message>
        <source>did not confirm what was to be stored</source>
        <translation>saklanması isteneni onaylamadı</translation>
    </message>
    <message>
        <source>does not answer: expected a Palpate device that is switched on</source>
        <translation>yanıt vermiyor; beklenen: açık bir Palpate aygıtı</translation>
    </message>
    <message>
        <source>entries that share their bytes</source>
        <translation>aynı baytları paylaşan girdiler</translation>
    </message>
    <message>
        <source>fewer</source>
        <translation>daha az</translation>
    </message>
    <message>
        <source>finite coordinates</source>
        <translation>sonlu koordinatlar</translation>
    </message>
    <message>
        <source>more bytes than stated</source>
        <translation>belirtilenden çok bayt</translation>
    </message>
    <message>
        <source>more than %1 levels</source>
        <translation>%1 düzeyden çok</translation>
    </message>
    <message>
        <source>more than ten million triangles</source>
        <translation>on milyondan çok üçgen</translation>
    </message>
    <message>
        <source>no extension</source>
        <translation>uzantısı olmayan bir ad</translation>
    </message>
    <message>
        <source>no name or size</source>
        <translation>adı ya da boyu olmayan bir girdi</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>böyle bir dosya yok</translation>
    </message>
    <message>
        <source>no triangle that has an area</source>
        <translation>alanı olan üçgen yok</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>hiç üçgen yok</translation>
    </message>
    <message>
        <source>none such</source>
        <translation>böyle girdi olmaması</translation>
    </message>
    <message>
        <source>one</source>
        <translation>bir tane</translation>
    </message>
    <message>
        <source>one of .obj .stl .ply .glb .gltf .3ds .fbx .dae .off</source>
        <translation>şunlardan biri: .obj .stl .ply .glb .gltf .3ds .fbx .dae .off</translation>
    </message>
    <message>
        <source>one that can be opened</source>
        <translation>açılabilen bir girdi</translation>
    </message>
    <message>
        <source>one with an inside and an outside%1</source>
        <translation>içi ve dışı olan bir yüzey%1</translation>
    </message>
    <message>
        <source>pseudo terminal: %1</source>
        <translation>sözde uçbirim: %1</translation>
    </message>
    <message>
        <source>sends what is no frame of ours: another device, or another baud rate</source>
        <translation>bizim olmayan iletiler gönderiyor: başka bir aygıt ya da başka bir hız</translation>
    </message>
    <message>
        <source>so many on top of each other that counting was given up</source>
        <translation>sayılamayacak kadar çok üst üste üçgen</translation>
    </message>
    <message>
        <source>something other than a zip archive</source>
        <translation>zip arşivi olmayan bir şey</translation>
    </message>
    <message>
        <source>something that is not a regular file</source>
        <translation>sıradan bir dosya olmayan bir şey</translation>
    </message>
    <message>
        <source>speaks version %1 of the protocol, expected %2</source>
        <translation>protokolün %1 sürümünü konuşuyor; beklenen: %2</translation>
    </message>
    <message>
        <source>stored or deflated</source>
        <translation>saklanmış ya da deflate ile sıkıştırılmış</translation>
    </message>
    <message>
        <source>the bytes its checksum tells</source>
        <translation>sağlama toplamının söylediği baytlar</translation>
    </message>
    <message>
        <source>the cable is out</source>
        <translation>kablosu çıkmış</translation>
    </message>
    <message>
        <source>the extension %1</source>
        <translation>%1 uzantısı</translation>
    </message>
    <message>
        <source>the program palpate-read-mesh of this installation</source>
        <translation>bu kurulumun palpate-read-mesh programı</translation>
    </message>
    <message>
        <source>two entries of one name</source>
        <translation>aynı adda iki girdi</translation>
    </message>
    <message>
        <source>two entries of this name</source>
        <translation>bu adda iki girdi</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>köşe %1</translation>
    </message>
</context>
</TS>
